// SPDX-License-Identifier: MIT
// Debian's libc++abi for WebAssembly is compiled without exceptions: its operator new ends the program where
// memory ends.
#include <cstdlib>
#include <new>

void* operator new(std::size_t size) {
    for (;;) {
        if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
        const std::new_handler handler = std::get_new_handler();
        if (!handler) throw std::bad_alloc();
        handler();
    }
}

void* operator new[](std::size_t size) {
    return ::operator new(size);
}
