// SPDX-License-Identifier: MIT
// Compiled once for each instruction set, with PEAK_NAME as the function's name.
namespace versorium::textbook {

double PEAK_NAME(int rounds) {
#if defined(__AVX512F__)
    constexpr int kBytes = 64;
#else
    constexpr int kBytes = 32;
#endif
    typedef double Register __attribute__((vector_size(kBytes)));
    // Twelve chains hide the latency of any processor at hand.
    Register sums[12] = {};
    Register factor = Register{} + 0.999, term = Register{} + 1e-3;
    for (int i = 0; i < 12; ++i) sums[i] = Register{} + static_cast<double>(i);
    for (int round = 0; round < rounds; ++round) {
#pragma GCC unroll 12
        for (int i = 0; i < 12; ++i) sums[i] = sums[i] * factor + term;
        asm volatile("" : "+x"(factor));
    }
    double all = 0;
    for (const Register& sum : sums) all += sum[0];
    constexpr double kOperations = 2.0 * 12 * (kBytes / 8);
    return all < 0 ? 0 : kOperations * rounds;
}

}  // namespace versorium::textbook
