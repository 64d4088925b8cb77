// SPDX-License-Identifier: MIT
// Gives a fuzz target its corpus, and each file of it with small changes: always the same ones, so
// that what fails fails again.  replay CHANGES FILE…
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size);

namespace {

// xorshift64*
struct Chance {
    unsigned long long state = 0x9E3779B97F4A7C15ull;
    std::size_t below(std::size_t limit) {
        state ^= state >> 12, state ^= state << 25, state ^= state >> 27;
        return limit == 0 ? 0 : (state * 0x2545F4914F6CDD1Dull >> 32) % limit;
    }
};

void run(const std::string& text) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const unsigned char*>(text.data()), text.size());
}

// A byte turned, a piece taken out, doubled, or brought in from elsewhere in the same text.
std::string changed(std::string text, Chance& chance) {
    static const std::string kBits[] = {
        "```",  "\n## ", "---\n",     ": ",     "=>", "1e999", "-",  "(",
        "\xff", "%",     "link: v1:", "when: ", "**", "[",     "\t", "{\"a\":"};
    for (std::size_t times = 1 + chance.below(3); times > 0 && !text.empty(); --times) {
        const std::size_t at = chance.below(text.size());
        const std::size_t length = chance.below(std::min<std::size_t>(64, text.size() - at) + 1);
        switch (chance.below(5)) {
            case 0:
                text[at] = static_cast<char>(chance.below(256));
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, text.substr(at, length));
                break;
            case 3:
                text.insert(at, text.substr(chance.below(text.size()), length));
                break;
            default:
                text.insert(at, kBits[chance.below(std::size(kBits))]);
        }
    }
    return text;
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 3) {
        std::fprintf(stderr, "replay CHANGES FILE…\n");
        return 2;
    }
    const int changes = std::atoi(arguments[1]);
    Chance chance;
    long inputs = 0;
    for (int k = 2; k < count; ++k) {
        std::ifstream file(arguments[k], std::ios::binary);
        if (!file) {
            std::fprintf(stderr, "%s: cannot be read\n", arguments[k]);
            return 2;
        }
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        run(text);
        for (int n = 0; n < changes; ++n, ++inputs) run(changed(text, chance));
    }
    std::printf("%ld inputs\n", inputs);
    return 0;
}
