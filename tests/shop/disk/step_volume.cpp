// SPDX-License-Identifier: MIT
// step_volume FILE: the volume of the one solid in a STEP file, mm³, as Open CASCADE reads it.
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdio>

int main(int count, char** words) {
    if (count != 2) {
        std::fputs("usage: step_volume FILE\n", stderr);
        return 2;
    }
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPControl_Reader reader;
    if (reader.ReadFile(words[1]) != IFSelect_RetDone || reader.TransferRoots() != 1) {
        std::fputs("step_volume: not one shape in a file that can be read\n", stderr);
        return 1;
    }
    const TopoDS_Shape shape = reader.OneShape();
    int solids = 0;
    for (TopExp_Explorer at(shape, TopAbs_SOLID); at.More(); at.Next()) ++solids;
    if (solids != 1 || !BRepCheck_Analyzer(shape).IsValid()) {
        std::fprintf(stderr, "step_volume: %d solids, or one that is not valid\n", solids);
        return 1;
    }
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties, 1e-9);
    std::printf("%.12g\n", properties.Mass());
    return 0;
}
