// SPDX-License-Identifier: MIT
// Values of the shape-modulus authors' program, met by the scene that the studio makes of their
// files. The files are not the project's: VERSORIUM_REFERENCE names the folder in which they lie.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "io/files.h"
#include "ui/controls/controls.h"
#include "ui/headless_gui.h"
#include "ui/session/open_file.h"

namespace versorium {
namespace {

TEST(Reference, TheStudiosSceneHasTheAuthorsValues) {
    const char* folder = std::getenv("VERSORIUM_REFERENCE");
    if (!folder) GTEST_SKIP() << "VERSORIUM_REFERENCE names no folder of reference values";
    const auto file = [&](const std::string& name) {
        Expected<std::vector<unsigned char>> bytes = readFile(std::string(folder) + "/" + name);
        EXPECT_TRUE(bytes) << name;
        return bytes ? *bytes : std::vector<unsigned char>();
    };
    for (const int degree : {10, 40})
        for (const auto& [alpha, beta] :
             {std::pair{"6", "0"}, std::pair{"40", "0.05"}, std::pair{"90", "0.02"}}) {
            SilentHost host;
            StudioContext context(host);
            context.newMap("shape-modulus");
            const std::string roots = "poly" + std::to_string(degree) + ".p4d";
            ASSERT_TRUE(openBytes(context, "bunny_norm_100.f3d", file("bunny_norm_100.f3d")).ok());
            ASSERT_TRUE(openBytes(context, roots, file(roots)).ok());
            ASSERT_TRUE(setControl(context, "alpha", alpha));
            ASSERT_TRUE(setControl(context, "beta", beta));
            ASSERT_TRUE(setControl(context, "iterations", "3"));
            ASSERT_TRUE(setControl(context, "escape_radius", "20"));
            Binder binder;
            Job job(1);
            Expected<OrbitProgram> program = binder.bind(context.workspace.view(), job);
            ASSERT_TRUE(program) << program.status().message();
            // Through space instead of the view's plane.
            program->slice.axes.assign(3, std::vector<double>(program->slice.origin.size(), 0.0));
            for (std::size_t k = 0; k < 3; ++k) {
                program->slice.axes[k][k] = 1;
                program->slice.origin[k] = 0;
            }
            program->slice.origin[3] = 0;
            const std::vector<unsigned char> bytes =
                file("values_p" + std::to_string(degree) + "_a" + alpha + "_b" + beta + ".csv");
            std::istringstream lines(std::string(bytes.begin(), bytes.end()));
            std::string line;
            int count = 0, off = 0;
            while (std::getline(lines, line)) {
                double at[3], expected = 0;
                if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &at[0], &at[1], &at[2],
                                &expected) != 4)
                    continue;
                const double* coordinates[3] = {&at[0], &at[1], &at[2]};
                const FieldName fields[] = {FieldName::logModulus};
                const double value = evaluateFields(*program, 1, coordinates, fields)[0][0];
                ++count;
                off += !(std::abs(value - expected) <= 1e-9 * std::max(1.0, std::abs(expected)));
            }
            EXPECT_EQ(count, 2000);
            // A bailout or a border decides at 1 point of 1000 at most.
            EXPECT_LE(off, 2) << "degree " << degree << ", alpha " << alpha;
        }
}

}  // namespace
}  // namespace versorium
