// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/surface/step/step_file.hpp"
#include "output/surface/step/step_library.hpp"

#include <fmt/format.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Interface_Static.hxx>
#include <STEPConstruct.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>
#include <vector>

namespace camopt {

namespace {

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

void write(const std::filesystem::path& path, std::span<const BsplineSurface> surfaces) {
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
    write_step_model(path, writer);
}

}  // namespace

bool step_available() {
    return true;
}

void write_step_file(const std::filesystem::path& path, std::span<const BsplineSurface> surfaces) {
    if (surfaces.empty()) throw InputError("STEP: there is no surface to write");
    try {
        write(path, surfaces);
    } catch (const Standard_Failure& failure) {
        throw InputError(
            fmt::format("STEP: Open CASCADE refuses the surfaces: {}", failure.GetMessageString()));
    }
}

}  // namespace camopt
