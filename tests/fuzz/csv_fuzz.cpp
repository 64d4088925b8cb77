// SPDX-License-Identifier: MIT
// Tables: every row has as many cells as the head line, and lines rise.
#include <cstddef>

#include "io/csv.h"

using namespace versorium;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    Expected<CsvReader> reader = CsvReader::open({reinterpret_cast<const char*>(data), size});
    if (!reader) {
        if (reader.status().message().empty()) __builtin_trap();
        return 0;
    }
    std::size_t line = reader->headerLine();
    while (true) {
        const Expected<bool> more = reader->next();
        if (!more || !*more) return 0;
        if (reader->cells().size() != reader->header().size() || reader->line() <= line)
            __builtin_trap();
        line = reader->line();
        for (const std::string& cell : reader->cells()) (void)reader->number(cell);
    }
}
