// SPDX-License-Identifier: MIT
// Lessons and teachers' links are foreign input: whatever stands in them, reading ends, and says
// what is wrong. One target for libFuzzer (preset fuzz), or for replay.cpp.
#include <cstddef>
#include <string>
#include <string_view>

#include "lesson/session.h"
#include "lesson/spoken.h"
#include "lesson/teacher_link.h"

using namespace versorium;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    Expected<Lesson> lesson = parseLesson(text, "foreign.en.md");
    if (!lesson && lesson.status().message().empty()) __builtin_trap();
    if (lesson) {
        LessonSession session(std::move(*lesson));
        for (std::size_t k = 0; k < session.lesson().steps.size(); ++k) {
            session.goTo(k);
            for (const char* answer : {"1", "0.5", "1, 2", ""}) (void)session.commit(answer);
            for (const MarkdownBlock& block : session.step().prose)
                (void)spokenParts(plainText(block), "es");
        }
        if (!session.resume(session.progress()).ok()) __builtin_trap();
        (void)answersAsText(session);
    }
    (void)parseTeacherLink(std::string(text));
    return 0;
}
