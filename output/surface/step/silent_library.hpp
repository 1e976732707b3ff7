// SPDX-License-Identifier: MIT
// Open CASCADE prints to stdout unless its printers are taken away; they are put back at the end. Internal.
#pragma once

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>

namespace camopt {

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

}  // namespace camopt
