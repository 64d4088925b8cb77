// SPDX-License-Identifier: MIT
#include "io/csv.h"

#include <gtest/gtest.h>

namespace versorium {
namespace {

using Table = std::vector<std::vector<std::string>>;

// Head line and rows, or the message.
std::string tableOf(std::string_view text, Table& table) {
    table.clear();
    Expected<CsvReader> reader = CsvReader::open(text);
    if (!reader) return reader.status().message();
    table.push_back(reader->header());
    while (true) {
        const Expected<bool> more = reader->next();
        if (!more) return more.status().message();
        if (!*more) return "";
        table.push_back(reader->cells());
    }
}

TEST(Csv, OneTableInEverySpelling) {
    const Table expected{{"x", "Y"}, {"0.5", "-1"}, {"", "a b"}};
    for (const char* text :
         {"x,Y\n0.5,-1\n,a b\n", "x,Y\r\n0.5,-1\r\n,a b\r\n", "x,Y\r0.5,-1\r,a b",
          "\xef\xbb\xbfx,Y\n0.5,-1\n,a b\n", "x;Y\n0.5;-1\n;a b\n", "x\tY\n0.5\t-1\n\ta b\n",
          "\"x\",\"Y\"\n\"0.5\", \"-1\" \n\"\",\"a b\"\n", "sep=;\r\nx;Y\r\n0.5;-1\r\n;a b\r\n",
          "\n\r\n  \nx , Y\n\n 0.5 ,-1\n,\n,a b\n\n,"}) {
        Table table;
        EXPECT_EQ(tableOf(text, table), "") << text;
        EXPECT_EQ(table, expected) << text;
    }
}

TEST(Csv, QuotesKeepSeparatorsQuotesAndLineEnds) {
    Table table;
    EXPECT_EQ(tableOf("a,\"b;c\"\n\"1,2\",\"say \"\"so\"\"\r\nor not\"\n", table), "");
    EXPECT_EQ(table, (Table{{"a", "b;c"}, {"1,2", "say \"so\"\nor not"}}));
}

TEST(Csv, RowsKnowTheirLines) {
    Expected<CsvReader> reader = CsvReader::open("\r\rx,y\r1,2\r\r\"3\r\",4\r5,6\r");
    ASSERT_TRUE(reader.ok());
    EXPECT_EQ(reader->headerLine(), 3u);
    std::vector<std::size_t> lines;
    while (true) {
        const Expected<bool> more = reader->next();
        ASSERT_TRUE(more.ok()) << more.status().message();
        if (!*more) break;
        lines.push_back(reader->line());
    }
    EXPECT_EQ(lines, (std::vector<std::size_t>{4, 6, 8}));
}

TEST(Csv, WhatIsAmbiguousIsRefusedWithItsLine) {
    Table table;
    const std::pair<const char*, const char*> cases[] = {
        {"", "no head line"},
        {"\xef\xbb\xbf\n\n", "no head line"},
        {"x,y;z\n", "line 1: the head line has more than one"},
        {"x,y\n1\n", "line 2: 1 cell separated by commas, but the head line has 2"},
        {"x,y\n1,2\n0,5,1,2\n", "line 3: 4 cells"},
        {"x,y\n0,5,1,2\n", "decimal comma"},
        {"x,y\n\n\"1,2\n3,4\n", "line 3: a quoted cell has no end"},
        {"x,y\n\"1\"2,3\n", "line 2: after a quoted cell"},
        {"x,y\n1\"2,3\n", "line 2: a quote stands within a cell"},
    };
    for (const auto& [text, message] : cases)
        EXPECT_NE(tableOf(text, table).find(message), std::string::npos)
            << text << ": " << tableOf(text, table);
    EXPECT_NE(tableOf(std::string_view("\xff\xfex\0,\0", 6), table).find("UTF-16"),
              std::string::npos);
    EXPECT_NE(tableOf(std::string_view("x,\0y\n", 5), table).find("no text"), std::string::npos);
}

TEST(Csv, ADecimalCommaIsANumberWhereNoCommaSeparates) {
    for (const char* head : {"x;y\n", "x\ty\n"}) {
        const Expected<CsvReader> reader = CsvReader::open(head);
        ASSERT_TRUE(reader.ok());
        EXPECT_EQ(*reader->number("0,5"), 0.5);
        EXPECT_EQ(*reader->number("-1.25e3"), -1250);
        for (const char* word : {"1.234,5", "1,2,3", "", "nan", "inf", "0x10", "1e999"})
            EXPECT_FALSE(reader->number(word).ok()) << word;
    }
    const Expected<CsvReader> commas = CsvReader::open("x,y\n");
    const Expected<double> number = commas->number("0,5");
    ASSERT_FALSE(number.ok());
    EXPECT_NE(number.status().message().find("decimal comma"), std::string::npos);
}

}  // namespace
}  // namespace versorium
