// SPDX-License-Identifier: MIT
#include "lesson/markdown.h"

#include <md4c.h>

#include <algorithm>
#include <functional>

namespace versorium {
namespace {

// Takes md4c's calls and keeps the blocks. A fault stops the parser.
class Collector {
  public:
    Collector(std::string_view text, int firstLine) : text_(text), firstLine_(firstLine) {}

    std::vector<MarkdownBlock> blocks;
    Status status;

    int enterBlock(MD_BLOCKTYPE type, void* detail) {
        switch (type) {
            case MD_BLOCK_DOC:
                return 0;
            case MD_BLOCK_H:
                return open({MarkdownBlock::Kind::heading, 0,
                             static_cast<int>(static_cast<MD_BLOCK_H_DETAIL*>(detail)->level)});
            case MD_BLOCK_P:
                if (lists_.empty()) return open({MarkdownBlock::Kind::paragraph});
                // A second paragraph of an item goes on in it.
                return 0;
            case MD_BLOCK_UL:
            case MD_BLOCK_OL:
                lists_.push_back(
                    type == MD_BLOCK_OL
                        ? static_cast<int>(static_cast<MD_BLOCK_OL_DETAIL*>(detail)->start)
                        : -1);
                if (static_cast<int>(lists_.size()) > kMarkdownDepth)
                    return fault("lists are nested too deeply");
                return 0;
            case MD_BLOCK_LI: {
                MarkdownBlock item{MarkdownBlock::Kind::item, 0, static_cast<int>(lists_.size())};
                if (lists_.back() >= 0) item.number = lists_.back()++;
                return open(std::move(item));
            }
            case MD_BLOCK_CODE: {
                const auto& code = *static_cast<MD_BLOCK_CODE_DETAIL*>(detail);
                if (open({MarkdownBlock::Kind::fence}) != 0) return 1;
                note(code.info.text);
                if (code.info.text) blocks.back().info.assign(code.info.text, code.info.size);
                return 0;
            }
            case MD_BLOCK_QUOTE:
                return fault("quotations (>) are not part of lessons");
            case MD_BLOCK_HR:
                return fault("rules (---) are not part of lessons: a step begins with ##");
            case MD_BLOCK_HTML:
                return fault("HTML is not part of lessons");
            default:
                return fault("tables are not part of lessons");
        }
    }
    int leaveBlock(MD_BLOCKTYPE type) {
        if (type == MD_BLOCK_UL || type == MD_BLOCK_OL) lists_.pop_back();
        if (type == MD_BLOCK_P && !lists_.empty() && !blocks.empty() && !blocks.back().runs.empty())
            blocks.back().runs.push_back({" ", false, false, false});
        return 0;
    }
    int enterSpan(MD_SPANTYPE type) {
        if (type == MD_SPAN_EM)
            ++emphasis_;
        else if (type == MD_SPAN_STRONG)
            ++strong_;
        else if (type == MD_SPAN_CODE)
            ++code_;
        else if (type == MD_SPAN_IMG)
            return fault("images are not part of lessons");
        else
            return fault("links are not part of lessons");
        return 0;
    }
    int leaveSpan(MD_SPANTYPE type) {
        if (type == MD_SPAN_EM) --emphasis_;
        if (type == MD_SPAN_STRONG) --strong_;
        if (type == MD_SPAN_CODE) --code_;
        return 0;
    }
    int takeText(MD_TEXTTYPE type, const char* text, MD_SIZE size) {
        if (blocks.empty()) return 0;
        if (type == MD_TEXT_HTML) return fault("HTML is not part of lessons");
        note(text);
        std::string piece(text, size);
        if (type == MD_TEXT_BR || type == MD_TEXT_SOFTBR) piece = " ";
        if (type == MD_TEXT_NULLCHAR) return fault("a zero byte");
        if (type == MD_TEXT_ENTITY) return fault("\"" + piece + "\": write the character itself");
        MarkdownBlock& block = blocks.back();
        if (block.kind == MarkdownBlock::Kind::fence) {
            block.text += piece;
            return 0;
        }
        const TextRun run{"", strong_ > 0, emphasis_ > 0, code_ > 0};
        const auto same = [&](const TextRun& last) {
            return last.strong == run.strong && last.emphasis == run.emphasis &&
                   last.code == run.code;
        };
        if (block.runs.empty() || !same(block.runs.back())) block.runs.push_back(run);
        block.runs.back().text += piece;
        return 0;
    }

  private:
    std::string_view text_;
    int firstLine_;
    int at_ = 0;  // the line of what was seen last
    std::vector<int> lists_;
    int emphasis_ = 0, strong_ = 0, code_ = 0;

    int open(MarkdownBlock block) {
        if (blocks.size() >= kMarkdownBlocks) return fault("the text is too long");
        blocks.push_back(std::move(block));
        return 0;
    }
    // md4c hands out pieces of the text itself wherever it can: where one lies says its line.
    void note(const char* piece) {
        const std::less<const char*> before;
        const char* begin = text_.data();
        const char* end = begin + text_.size();
        if (!piece || before(piece, begin) || !before(piece, end)) return;
        at_ = firstLine_ + static_cast<int>(std::count(begin, piece, '\n'));
        if (!blocks.empty() && blocks.back().line == 0) blocks.back().line = at_;
    }
    int fault(const std::string& message) {
        status = Status::data(at_ > 0 ? "line " + std::to_string(at_) + " or after it: " + message
                                      : message);
        return 1;
    }
};

}  // namespace

Expected<std::vector<MarkdownBlock>> parseMarkdown(std::string_view text, int firstLine) {
    if (text.size() > kMarkdownBytes)
        return Status::data("the text has more than " + std::to_string(kMarkdownBytes) + " bytes");
    Collector collector(text, firstLine);
    MD_PARSER parser{};
    parser.flags = MD_FLAG_NOINDENTEDCODEBLOCKS | MD_FLAG_NOHTML;
    parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* data) {
        return static_cast<Collector*>(data)->enterBlock(type, detail);
    };
    parser.leave_block = [](MD_BLOCKTYPE type, void*, void* data) {
        return static_cast<Collector*>(data)->leaveBlock(type);
    };
    parser.enter_span = [](MD_SPANTYPE type, void*, void* data) {
        return static_cast<Collector*>(data)->enterSpan(type);
    };
    parser.leave_span = [](MD_SPANTYPE type, void*, void* data) {
        return static_cast<Collector*>(data)->leaveSpan(type);
    };
    parser.text = [](MD_TEXTTYPE type, const MD_CHAR* piece, MD_SIZE size, void* data) {
        return static_cast<Collector*>(data)->takeText(type, piece, size);
    };
    const int failed =
        md_parse(text.data(), static_cast<MD_SIZE>(text.size()), &parser, &collector);
    if (!collector.status.ok()) return collector.status;
    if (failed != 0) return Status::data("the text cannot be read as Markdown");
    for (MarkdownBlock& block : collector.blocks)
        while (!block.runs.empty() && block.runs.back().text == " ") block.runs.pop_back();
    return std::move(collector.blocks);
}

std::string plainText(const MarkdownBlock& block) {
    std::string text;
    for (const TextRun& run : block.runs) text += run.text;
    return text;
}

std::string plainText(const std::vector<MarkdownBlock>& blocks) {
    std::string text;
    for (const MarkdownBlock& block : blocks) {
        if (!text.empty()) text += "\n";
        if (block.kind == MarkdownBlock::Kind::item)
            text += block.number > 0 ? std::to_string(block.number) + ". " : "• ";
        text += plainText(block);
    }
    return text;
}

}  // namespace versorium
