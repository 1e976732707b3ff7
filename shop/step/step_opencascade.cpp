// SPDX-License-Identifier: MIT
// The part "step": a separate module, or a part of camopt_shop_step.
#include "core/errors.hpp"
#include "core/platform/part_entry.hpp"
#include "core/units.hpp"
#include "shop/step/step_part.hpp"

#include <fmt/format.h>

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <STEPConstruct.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopAbs_ShapeEnum.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>
#include <sstream>

namespace camopt {

namespace {

// What the two STEP writers share of Open CASCADE. Internal.

/// Open CASCADE prints to stdout unless its printers are taken away; they are put back at the end.
class SilentLibrary {
 public:
    SilentLibrary() : printers_(Message::DefaultMessenger()->Printers()) {
        Message::DefaultMessenger()->ChangePrinters().Clear();
    }
    ~SilentLibrary() { Message::DefaultMessenger()->ChangePrinters() = printers_; }
    SilentLibrary(const SilentLibrary&) = delete;
    SilentLibrary& operator=(const SilentLibrary&) = delete;

 private:
    Message_SequenceOfPrinters printers_;
};

/// What was transferred to the writer.
std::string model_text(STEPControl_Writer& writer, const StepHeader& words) {
    const auto text_of = [](const std::string& said) { return new TCollection_HAsciiString(said.c_str()); };
    APIHeaderSection_MakeHeader header(writer.Model());
    header.SetName(text_of(words.part));
    header.SetAuthorValue(1, text_of(words.author));
    header.SetOrganizationValue(1, text_of(words.organisation));
    header.SetOriginatingSystem(text_of(words.system));
    StepData_StepWriter text(writer.Model());
    text.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
    std::ostringstream bytes;
    if (!text.Print(bytes)) throw InputError("STEP: Open CASCADE could not print the model");
    return bytes.str();
}

struct KnotList {
    std::vector<double> value;
    std::vector<int> multiplicity;

    explicit KnotList(const std::vector<double>& knots) {
        for (const double knot : knots) {
            if (value.empty() || knot != value.back()) {
                value.push_back(knot);
                multiplicity.push_back(0);
            }
            ++multiplicity.back();
        }
    }
};

Handle(Geom_BSplineSurface) surface_of(const BsplineSurface& from) {
    const int columns = static_cast<int>(from.columns()), rows = static_cast<int>(from.rows());
    TColgp_Array2OfPnt poles(1, columns, 1, rows);
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            const Eigen::Vector3d mm =
                from.poles[static_cast<std::size_t>(r) * from.columns() + static_cast<std::size_t>(c)] /
                units::millimetre;
            poles.SetValue(c + 1, r + 1, gp_Pnt(mm.x(), mm.y(), mm.z()));
        }
    const KnotList u(from.knots_u), v(from.knots_v);
    const int u_last = static_cast<int>(u.value.size()), v_last = static_cast<int>(v.value.size());
    // Arrays that look into the lists.
    const TColStd_Array1OfReal u_knots(u.value.front(), 1, u_last), v_knots(v.value.front(), 1, v_last);
    const TColStd_Array1OfInteger u_counts(u.multiplicity.front(), 1, u_last),
        v_counts(v.multiplicity.front(), 1, v_last);
    return new Geom_BSplineSurface(poles, u_knots, v_knots, u_counts, v_counts, from.degree_u, from.degree_v);
}

TopoDS_Face face_of(const BsplineSurface& surface) {
    constexpr double tolerance = 1e-7;  // mm: below what any machine sees, above rounding
    BRepBuilderAPI_MakeFace face(surface_of(surface), tolerance);
    if (!face.IsDone()) throw InputError(fmt::format("STEP: the surface {} makes no face", surface.name));
    return face.Face();
}

void name_face(const STEPControl_Writer& writer, const TopoDS_Face& face, const std::string& name) {
    const Handle(StepRepr_RepresentationItem) item =
        STEPConstruct::FindEntity(writer.WS()->TransferWriter()->FinderProcess(), face);
    if (!item.IsNull()) item->SetName(new TCollection_HAsciiString(name.c_str()));
}

std::string text_of_surfaces(std::span<const BsplineSurface> surfaces, const StepHeader& header) {
    const SilentLibrary silent;
    STEPControl_Writer writer;
    Interface_Static::SetCVal("write.step.unit", "MM");
    Interface_Static::SetCVal("write.step.schema", "AP214IS");
    BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    std::vector<TopoDS_Face> faces;
    for (const BsplineSurface& surface : surfaces) {
        faces.push_back(face_of(surface));
        builder.Add(compound, faces.back());
    }
    if (writer.Transfer(compound, STEPControl_AsIs) != IFSelect_RetDone)
        throw InputError("STEP: Open CASCADE could not translate the surfaces");
    for (std::size_t i = 0; i < faces.size(); ++i) name_face(writer, faces[i], surfaces[i].name);
    return model_text(writer, header);
}

/// On the plate's lower face.
class PlateShape {
 public:
    explicit PlateShape(const Plate& plate) : plate_(plate) {}

    [[nodiscard]] TopoDS_Shape solid() const {
        const TopoDS_Shape plate = layer(plate_.outline, plate_.hole, -bottom());
        if (!plate_.groove) return plate;
        // The channel as a body of the plate's lower face, lifted to where it is cut out, and beyond the
        // upper face.
        const double depth = plate_.groove->depth / units::millimetre;
        gp_Trsf lift;
        lift.SetTranslation(gp_Vec(0.0, 0.0, -bottom() - depth));
        const TopoDS_Shape channel = layer(plate_.groove->outer, plate_.groove->inner, 2.0 * depth);
        BRepAlgoAPI_Cut cut(plate, BRepBuilderAPI_Transform(channel, lift, true).Shape());
        if (!cut.IsDone()) throw InputError(fmt::format("STEP: the groove of {} cannot be cut", plate_.name));
        const TopExp_Explorer solids(cut.Shape(), TopAbs_SOLID);
        if (!solids.More()) throw InputError(fmt::format("STEP: nothing is left of {}", plate_.name));
        return solids.Current();
    }

 private:
    const Plate& plate_;

    /// From the lower face upwards.
    [[nodiscard]] TopoDS_Shape layer(const std::vector<PlateEdge>& outline,
                                     const std::vector<PlateEdge>& inner, double height) const {
        const gp_Pln plane(gp_Pnt(0.0, 0.0, bottom()), gp_Dir(0.0, 0.0, 1.0));
        BRepBuilderAPI_MakeFace face(plane, wire(outline));
        if (!inner.empty()) {
            TopoDS_Wire hole = wire(inner);
            if (turns_to_the_left(inner)) hole.Reverse();
            face.Add(hole);
        }
        if (!face.IsDone()) throw InputError(fmt::format("STEP: the plate {} makes no face", plate_.name));
        return BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0.0, 0.0, height)).Shape();
    }
    [[nodiscard]] static bool turns_to_the_left(const std::vector<PlateEdge>& edges) {
        std::vector<Eigen::Vector2d> corners;
        for (const PlateEdge& part : edges) {
            corners.push_back(part.from);
            if (part.kind == PlateEdge::Kind::arc) corners.push_back(part.middle);
            corners.insert(corners.end(), part.poles.begin(), part.poles.end());
        }
        double twice_area = 0.0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Eigen::Vector2d &here = corners[i], &next = corners[(i + 1) % corners.size()];
            twice_area += here.x() * next.y() - here.y() * next.x();
        }
        return twice_area > 0.0;
    }
    [[nodiscard]] double bottom() const { return -plate_.thickness / units::millimetre; }
    [[nodiscard]] gp_Pnt place(const Eigen::Vector2d& point) const {
        return {point.x() / units::millimetre, point.y() / units::millimetre, bottom()};
    }
    [[nodiscard]] TopoDS_Edge edge(const PlateEdge& from) const {
        switch (from.kind) {
            case PlateEdge::Kind::line:
                return BRepBuilderAPI_MakeEdge(place(from.from), place(from.to));
            case PlateEdge::Kind::arc: {
                const GC_MakeArcOfCircle arc(place(from.from), place(from.middle), place(from.to));
                return BRepBuilderAPI_MakeEdge(arc.Value());
            }
            case PlateEdge::Kind::curve:
                break;
        }
        return BRepBuilderAPI_MakeEdge(curve(from));
    }
    [[nodiscard]] Handle(Geom_BSplineCurve) curve(const PlateEdge& from) const {
        const int count = static_cast<int>(from.poles.size());
        TColgp_Array1OfPnt poles(1, count);
        for (int i = 0; i < count; ++i) poles.SetValue(i + 1, place(from.poles[static_cast<std::size_t>(i)]));
        const KnotList knots(from.knots);
        const int last = static_cast<int>(knots.value.size());
        const int degree = static_cast<int>(from.knots.size()) - count - 1;
        return new Geom_BSplineCurve(poles, TColStd_Array1OfReal(knots.value.front(), 1, last),
                                     TColStd_Array1OfInteger(knots.multiplicity.front(), 1, last), degree);
    }
    [[nodiscard]] TopoDS_Wire wire(const std::vector<PlateEdge>& edges) const {
        BRepBuilderAPI_MakeWire maker;
        for (const PlateEdge& part : edges) maker.Add(edge(part));
        if (!maker.IsDone()) throw InputError(fmt::format("STEP: the edges of {} make no line", plate_.name));
        return maker.Wire();
    }
};

StepSolid solid_of_plate(const Plate& plate, const StepHeader& header) {
    const SilentLibrary silent;
    const TopoDS_Shape solid = PlateShape(plate).solid();
    GProp_GProps properties;
    constexpr double precision = 1e-9;  // relative, of the volume
    BRepGProp::VolumeProperties(solid, properties, precision);
    STEPControl_Writer writer;
    Interface_Static::SetCVal("write.step.unit", "MM");
    Interface_Static::SetCVal("write.step.schema", "AP214IS");
    Interface_Static::SetCVal("write.step.product.name", plate.name.c_str());
    if (writer.Transfer(solid, STEPControl_ManifoldSolidBrep) != IFSelect_RetDone)
        throw InputError("STEP: Open CASCADE could not translate the solid");
    return {model_text(writer, header), std::abs(properties.Mass()) * std::pow(units::millimetre, 3)};
}

/// What is refused, in camopt's words.
template <class Function>
auto asked(const char* what, Function&& function) {
    try {
        return function();
    } catch (const Standard_Failure& failure) {
        throw InputError(
            fmt::format("STEP: Open CASCADE refuses the {}: {}", what, failure.GetMessageString()));
    }
}

constexpr StepPart step_table = {
    [](std::span<const BsplineSurface> surfaces, const StepHeader& header) {
        return asked("surfaces", [&] { return text_of_surfaces(surfaces, header); });
    },
    [](const Plate& plate, const StepHeader& header) {
        return asked("solid", [&] { return solid_of_plate(plate, header); });
    },
};

}  // namespace

}  // namespace camopt

extern "C" const void* camopt_part_step(const char* build);
const void* camopt_part_step(const char* build) {
    return camopt::part_for(build, &camopt::step_table);
}
