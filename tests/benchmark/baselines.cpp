// SPDX-License-Identifier: MIT
#include "benchmark/baselines.h"

#include <cmath>

#include "benchmark/views.h"

namespace versorium::textbook {

template <class T>
std::int64_t mandelbrot(int side, int iterations, std::vector<std::int32_t>& steps) {
    std::int64_t total = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const T cx = static_cast<T>(kHome.u(x, side)), cy = static_cast<T>(kHome.v(y, side));
            T a = 0, b = 0, aa = 0, bb = 0;
            int n = 0;
            while (n < iterations && aa + bb <= 4) {
                b = 2 * a * b + cy;
                a = aa - bb + cx;
                aa = a * a;
                bb = b * b;
                ++n;
            }
            steps[static_cast<std::size_t>(y * side + x)] = n;
            total += n;
        }
    return total;
}
template std::int64_t mandelbrot<float>(int, int, std::vector<std::int32_t>&);
template std::int64_t mandelbrot<double>(int, int, std::vector<std::int32_t>&);

std::int64_t planarDotProducts(int side, double height, int iterations, double squaredRadius,
                               const double* k, std::vector<std::int32_t>& steps) {
    const View view{0, 0, height};
    const auto dot = [](const double* p, const double* q) {
        return p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3];
    };
    std::int64_t total = 0;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            double x = view.u(column, side), y = view.v(row, side);
            int n = 0;
            while (n < iterations && x * x + y * y <= squaredRadius) {
                const double xs[] = {x, x * x, x * x * x, x * x * x * x};
                const double ys[] = {y, y * y, y * y * y, y * y * y * y};
                const double xys[] = {x * y, x * x * y, x * y * y, x * y * x * y};
                const double next = dot(k, xs) + dot(k + 4, ys) + dot(k + 8, xys) + k[12];
                y = dot(k + 15, xs) + dot(k + 19, ys) + dot(k + 23, xys) + k[27];
                x = next;
                ++n;
            }
            steps[static_cast<std::size_t>(row * side + column)] = n;
            total += n;
        }
    return total;
}

void averagedMembership(int side, double height, int iterations, double alpha,
                        const DistanceField& shape,
                        const std::vector<std::vector<RootList::Root>>& members,
                        std::vector<std::uint32_t>& counts) {
    const View view{0, 0, height};
    for (const auto& roots : members)
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                double x = view.u(column, side), y = view.v(row, side);
                int n = 0;
                while (n < iterations && x * x + y * y <= 400) {
                    double re = 1, im = 0;
                    for (const RootList::Root& root : roots) {
                        const double a = x - root.q[0], b = y - root.q[1];
                        const double next = re * a - im * b;
                        im = re * b + im * a;
                        re = next;
                    }
                    const double phi = shape.at(x, y, 0.0);
                    const double scale = std::exp(alpha * phi) / std::sqrt(re * re + im * im);
                    x = scale * re;
                    y = scale * im;
                    ++n;
                }
                counts[static_cast<std::size_t>(row * side + column)] += x * x + y * y <= 400;
            }
}

}  // namespace versorium::textbook
