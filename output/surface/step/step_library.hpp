// SPDX-License-Identifier: MIT
// What the two STEP writers share of Open CASCADE. Internal.
#pragma once

#include "core/errors.hpp"
#include "core/text/text_file.hpp"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <STEPControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <XSControl_WorkSession.hxx>
#include <filesystem>
#include <sstream>

namespace camopt {

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

/// What was transferred to the writer, as text first: the file is written and checked as every other is.
inline void write_step_model(const std::filesystem::path& path, STEPControl_Writer& writer) {
    StepData_StepWriter text(writer.Model());
    text.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
    std::ostringstream bytes;
    if (!text.Print(bytes)) throw InputError("STEP: Open CASCADE could not print the model");
    write_text_file(path, bytes.str());
}

}  // namespace camopt
