// SPDX-License-Identifier: MIT
#include "math/elementary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/random.h"

namespace versorium {
namespace {

// Distance of `value` from the true value in units in the last place of T at the true value.
template <class T>
double ulps(T value, long double truth) {
    if (std::isnan(value) && std::isnan(truth)) return 0;
    if (static_cast<T>(truth) == value) return 0;
    const T at = std::abs(static_cast<T>(truth));
    if (!std::isfinite(at)) return static_cast<double>(std::isfinite(value) ? 1e9 : 0);
    const long double unit = std::nextafter(at, std::numeric_limits<T>::infinity()) - at;
    return static_cast<double>(std::abs(static_cast<long double>(value) - truth) / unit);
}

// One row a function: how it is called, its truth, its arguments, its bound (elementary.h).
template <class T>
struct Row {
    const char* name;
    T (*function)(T, T);
    long double (*truth)(long double, long double);
    double bound;
    bool logarithmic;  // arguments spread over all magnitudes between low and high
    T low, high;
    T secondLow, secondHigh;
};

template <class T>
std::vector<Row<T>> rows() {
    const T tiny = std::numeric_limits<T>::denorm_min(), large = std::numeric_limits<T>::max();
    const T turn = sizeof(T) == 8 ? T(0x1p20) : T(0x1p10);
    return {
        {"exp", [](T x, T) { return exp(x); },
         [](long double x, long double) { return std::exp(x); }, 2, false,
         T(sizeof(T) == 8 ? -750 : -106), T(sizeof(T) == 8 ? 720 : 90), 0, 1},
        {"exp near 0", [](T x, T) { return exp(x); },
         [](long double x, long double) { return std::exp(x); }, 2, false, -1, 1, 0, 1},
        {"log", [](T x, T) { return log(x); },
         [](long double x, long double) { return std::log(x); }, 2, true, tiny, large, 0, 1},
        {"log near 1", [](T x, T) { return log(x); },
         [](long double x, long double) { return std::log(x); }, 2, false, T(0.5), T(2), 0, 1},
        {"atan2", [](T y, T x) { return atan2(y, x); },
         [](long double y, long double x) { return std::atan2(y, x); }, 3, false, -4, 4, -4, 4},
        {"atan2, far apart", [](T y, T x) { return atan2(y, x); },
         [](long double y, long double x) { return std::atan2(y, x); }, 3, true, tiny, large, -1,
         1},
        {"sin", [](T x, T) { return sin(x); },
         [](long double x, long double) { return std::sin(x); }, 3, false, -turn, turn, 0, 1},
        {"cos", [](T x, T) { return cos(x); },
         [](long double x, long double) { return std::cos(x); }, 3, false, -turn, turn, 0, 1},
        {"sin near 0", [](T x, T) { return sin(x); },
         [](long double x, long double) { return std::sin(x); }, 2, false, -1, 1, 0, 1},
    };
}

template <class T>
T argument(Random& random, bool logarithmic, T low, T high) {
    if (!logarithmic) return static_cast<T>(random.uniform(double(low), double(high)));
    return static_cast<T>(std::exp(random.uniform(std::log(double(low)), std::log(double(high)))));
}

template <class T>
void checkRows() {
    for (const Row<T>& row : rows<T>()) {
        Random random(11);
        double worst = 0;
        T where = 0;
        for (int i = 0; i < 100000; ++i) {
            const T x = argument(random, row.logarithmic, row.low, row.high);
            const T y =
                static_cast<T>(random.uniform(double(row.secondLow), double(row.secondHigh)));
            const long double truth = row.truth(x, y);
            // Close to a zero of sine the reduced argument has lost what the bound leaves out.
            if (row.name[0] != 'e' && row.name[0] != 'l' && row.name[0] != 'a' &&
                std::abs(truth) < (sizeof(T) == 8 ? 0x1p-20L : 0x1p-10L) && std::abs(x) > 1)
                continue;
            const double error = ulps(row.function(x, y), truth);
            if (error > worst) worst = error, where = x;
        }
        EXPECT_LE(worst, row.bound)
            << row.name << " at " << double(where) << ", bytes " << sizeof(T);
    }
}

TEST(Elementary, ErrorsStayInTheirBoundsInDouble) { checkRows<double>(); }
TEST(Elementary, ErrorsStayInTheirBoundsInFloat) { checkRows<float>(); }

TEST(Elementary, PowIsWithinItsBound) {
    Random random(5);
    for (int i = 0; i < 100000; ++i) {
        const double x = std::exp(random.uniform(-20, 20)), y = random.uniform(-30, 30);
        const long double truth = std::pow(static_cast<long double>(x), y);
        EXPECT_LE(ulps(pow(x, y), truth), 3 + 2 * std::abs(y * std::log(x))) << x << " ^ " << y;
    }
    EXPECT_EQ(pow(0.0, 2.0), 0);
    EXPECT_EQ(pow(0.0, 0.0), 1);
    EXPECT_EQ(pow(0.0, -1.0), std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(pow(-1.0, 0.5)));
}

TEST(Elementary, SpecialValues) {
    const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
    EXPECT_EQ(exp(infinity), infinity);
    EXPECT_EQ(exp(-infinity), 0);
    EXPECT_EQ(exp(0.0), 1);
    EXPECT_TRUE(std::isnan(exp(nan)));
    EXPECT_EQ(log(0.0), -infinity);
    EXPECT_EQ(log(infinity), infinity);
    EXPECT_EQ(log(1.0), 0);
    EXPECT_TRUE(std::isnan(log(-1.0)));
    EXPECT_TRUE(std::isnan(log(nan)));
    EXPECT_EQ(atan2(0.0, 0.0), 0);
    EXPECT_EQ(atan2(0.0, -1.0), M_PI);
    EXPECT_EQ(atan2(1.0, 0.0), M_PI / 2);
    EXPECT_EQ(atan2(infinity, infinity), M_PI / 4);
    EXPECT_EQ(atan2(-1.0, infinity), 0);
    EXPECT_TRUE(std::isnan(atan2(nan, 1.0)));
    EXPECT_TRUE(std::isnan(sin(infinity)));
    EXPECT_EQ(floor(-0.5), -1);
    EXPECT_EQ(floor(2.0), 2);
    EXPECT_EQ(floor(1e300), 1e300);
    EXPECT_EQ(min(1.0, nan), 1.0);
    EXPECT_TRUE(std::isnan(max(nan, 1.0)));
}

// Each lane must have the bits of the scalar: no operation here may depend on its neighbours.
template <class R>
void lanesEqualScalars() {
    using T = ScalarOf<R>;
    Random random(3);
    for (int round = 0; round < 3000; ++round) {
        T x[kLaneCount<R>], y[kLaneCount<R>];
        for (int i = 0; i < kLaneCount<R>; ++i) {
            x[i] = static_cast<T>(argument<double>(random, true, 1e-30, 1e30));
            if (i % 2) x[i] = static_cast<T>(random.uniform(-90, 90));
            if (i % 7 == 6) x[i] = std::numeric_limits<T>::quiet_NaN();
            y[i] = static_cast<T>(random.uniform(-3, 3));
        }
        R a, b;
        loadLanes(a, x);
        loadLanes(b, y);
        const auto same = [&](const char* name, const R& lanes, auto scalar) {
            for (int i = 0; i < kLaneCount<R>; ++i)
                EXPECT_EQ(toBits(lane(lanes, i)), toBits(scalar(x[i], y[i])))
                    << name << "(" << double(x[i]) << ", " << double(y[i]) << ")";
        };
        same("exp", exp(a), [](T u, T) { return exp(u); });
        same("log", log(a), [](T u, T) { return log(u); });
        same("sin", sin(a), [](T u, T) { return sin(u); });
        same("cos", cos(a), [](T u, T) { return cos(u); });
        same("atan2", atan2(a, b), [](T u, T v) { return atan2(u, v); });
        same("pow", pow(abs(a), b), [](T u, T v) { return pow(abs(u), v); });
        same("sqrt", sqrt(abs(a)), [](T u, T) { return sqrt(abs(u)); });
        same("floor", floor(a), [](T u, T) { return floor(u); });
    }
}

TEST(Elementary, LanesEqualScalarsBitForBit) {
    lanesEqualScalars<Lanes<double>>();
    lanesEqualScalars<Pair<Pair<Lanes<double>>>>();
    lanesEqualScalars<Lanes<float>>();
    lanesEqualScalars<Pair<Lanes<float>>>();
}

}  // namespace
}  // namespace versorium
