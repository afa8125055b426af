// SPDX-License-Identifier: GPL-3.0-or-later
//
// trixel sample.
#include "tests/app/cli_test.h"

#include <map>

namespace trixel::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr int kUnusable = 2;
constexpr int kPath = 3;

using Row = std::map<std::string, std::string>;

std::vector<std::string> split(const std::string& line)
{
    std::vector<std::string> fields;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');) {
        fields.push_back(field);
    }
    return fields;
}

std::vector<Row> table(const std::string& file)
{
    std::istringstream text(contentsOf(file));
    std::string line;
    std::getline(text, line);
    const auto names = split(line);
    std::vector<Row> rows;
    while (std::getline(text, line)) {
        const auto fields = split(line);
        EXPECT_EQ(fields.size(), names.size()) << line;
        Row row;
        for (std::size_t c = 0; c < std::min(fields.size(), names.size()); ++c) {
            row[names[c]] = fields[c];
        }
        rows.push_back(row);
    }
    return rows;
}

class Sample : public CommandLine
{
protected:
    static std::string golden(const std::string& name)
    {
        return std::string(TRIXEL_TEST_DATA) + "/filter/" + name;
    }

    std::string queries(const std::string& lines = "0,0.25,0.25,0.1,0,0,0.1\n") const
    {
        return write("q.csv", "face,u,v,uw1,vw1,uw2,vw2\n" + lines);
    }

    ProgramRun sample(const std::string& file,
                      const std::string& method,
                      const std::vector<std::string>& options = {}) const
    {
        std::vector<std::string> arguments = {
            "sample", file, "--queries", path("q.csv"), "--method", method, "-o", path("out.csv")};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return runTrixel(arguments);
    }
};

TEST_F(Sample, theExactMethodAgreesWithTheGoldenColumns)
{
    const ProgramRun run = runTrixel({"sample",
                                      golden("filter_a.ptx"),
                                      "--queries",
                                      golden("filter_a.csv"),
                                      "--method",
                                      "exact",
                                      "-o",
                                      path("out.csv")});
    EXPECT_THAT(run, EndsWith(0));
    const auto rows = table(path("out.csv"));
    ASSERT_EQ(rows.size(), 600U);
    for (const Row& row : rows) {
        for (const std::string c : {"0", "1", "2"}) {
            EXPECT_NEAR(std::stod(row.at("c" + c)), std::stod(row.at("exact" + c)), 1e-5);
        }
        EXPECT_EQ(row.at("method"), "exact");
    }
}

TEST_F(Sample, onItsMeshAPtxIsFilteredAtItsTrueShape)
{
    const std::vector<std::string> begin = {
        "sample", golden("filter_a.ptx"), "--queries", golden("filter_a.csv"), "--method", "exact"};
    auto bare = begin;
    bare.insert(bare.end(), {"-o", path("bare.csv")});
    auto meshed = begin;
    meshed.insert(meshed.end(), {"--mesh", golden("filter_a.obj"), "-o", path("meshed.csv")});
    EXPECT_THAT(runTrixel(bare), EndsWith(0));
    EXPECT_THAT(runTrixel(meshed), EndsWith(0));
    EXPECT_EQ(table(path("meshed.csv")).size(), 600U);
    EXPECT_NE(contentsOf(path("bare.csv")), contentsOf(path("meshed.csv")));
}

TEST_F(Sample, everyMethodThatHelpListsAnswers)
{
    const ProgramRun help = runTrixel({"sample", "--method", "help"});
    EXPECT_THAT(help, EndsWith(0));
    const std::string from = project({"--level", "4", "--fill", "0.25,0.5,1"});
    queries("0,0.25,0.25,0.1,0,0,0.1\n3,0.1,0.8,nan,0,0,inf\n2,nan,0,0,0,0,0\n");
    std::istringstream lines(help.out);
    int methods = 0;
    for (std::string line; std::getline(lines, line);) {
        // Lines about a parameter; and "auto", which would measure all others first.
        if (line.starts_with(' ') || line.starts_with("auto ")) {
            continue;
        }
        const std::string name = line.substr(0, line.find(' '));
        EXPECT_THAT(line, testing::EndsWith(".")) << "one sentence";
        EXPECT_THAT(sample(from, name), EndsWith(0)) << name;
        const auto rows = table(path("out.csv"));
        ASSERT_EQ(rows.size(), 3U) << name;
        for (const Row& row : rows) {
            EXPECT_THAT(row.at("method"), testing::AnyOf(name, "average"));
            EXPECT_NEAR(std::stod(row.at("c0")), 0.25, 3e-3) << name; // as uint8 has it
            EXPECT_NEAR(std::stod(row.at("c2")), 1, 1e-5) << name;
        }
        ++methods;
    }
    EXPECT_GE(methods, 12);
    EXPECT_THAT(help.out, HasSubstr("\nauto "));
    EXPECT_THAT(help.out, HasSubstr("equal-probes:N sets probes, 1 to 256 (else 16)"));
}

TEST_F(Sample, aPaintedProjectGivesItsColours)
{
    const std::string from = project({"--level", "6", "--fill", "0,0,0"});
    ASSERT_THAT(runTrixel({"paint",
                           from,
                           "--strokes",
                           strokes({{"radius", 0.2}, {"hardness", 1}}),
                           "-o",
                           path("p.trixel")}),
                EndsWith(0));
    queries("1,0.3,0.3,0.01,0,0,0.01\n0,0.1,0.1,0.01,0,0,0.01\n");
    ASSERT_THAT(sample(path("p.trixel"), "trilinear"), EndsWith(0));
    const auto rows = table(path("out.csv"));
    EXPECT_NEAR(std::stod(rows[0].at("c0")), 1, 1e-6);
    EXPECT_NEAR(std::stod(rows[0].at("c1")), 0, 1e-6);
    EXPECT_NEAR(std::stod(rows[1].at("c0")), 0, 1e-6);
    EXPECT_EQ(rows[0].at("level"), "6");
}

TEST_F(Sample, theNumberOfThreadsChangesNothing)
{
    std::string before;
    for (const char* threads : {"1", "2", "7"}) {
        EXPECT_THAT(runTrixel({"sample",
                               golden("filter_a.ptx"),
                               "--queries",
                               golden("filter_a.csv"),
                               "--method",
                               "stochastic:8",
                               "-o",
                               path("out.csv"),
                               "--threads",
                               threads}),
                    EndsWith(0));
        const std::string text = contentsOf(path("out.csv"));
        EXPECT_THAT(text, HasSubstr("stochastic:8"));
        EXPECT_TRUE(before.empty() || before == text) << threads;
        before = text;
    }
}

TEST_F(Sample, whatIsWrongGetsASentenceAndNoFile)
{
    const std::string from = project();
    queries();
    EXPECT_THAT(sample(from, "nearest"), FailsWith(kUnusable, "no filter method 'nearest'"));
    EXPECT_THAT(sample(from, "stochastic:5000"), FailsWith(kUnusable, "from 1 to 4096"));
    EXPECT_THAT(sample(from, "stochastic:2.5"), FailsWith(kUnusable, "a whole number"));
    EXPECT_THAT(sample(from, "trilinear:2"), FailsWith(kUnusable, "takes no parameter"));
    EXPECT_THAT(sample(from, "point", {"--tolerance", "0.1"}), FailsWith(kUnusable, "--tolerance"));
    for (const char* tolerance : {"0", "-1", "nan", "1%"}) {
        EXPECT_THAT(sample(from, "auto", {std::string("--tolerance=") + tolerance}),
                    FailsWith(kUnusable, "--tolerance"));
    }
    EXPECT_THAT(sample(from, "point", {"--threads", "0"}), FailsWith(kUnusable, "--threads"));
    EXPECT_THAT(sample(mesh(), "point"), FailsWith(kUnusable, "no texels"));
    EXPECT_THAT(sample(path("missing.ptx"), "point"), FailsWith(kPath, "missing.ptx"));
    EXPECT_THAT(sample(golden("filter_a.ptx"), "point", {"--mesh", mesh()}),
                FailsWith(kUnusable, "filter_a.ptx"));
    EXPECT_THAT(runTrixel({"sample", from, "--method", "point", "-o", path("out.csv")}),
                FailsWith(kUnusable, "--queries"));
    EXPECT_THAT(runTrixel({"sample", from, "--queries", path("q.csv"), "-o", path("out.csv")}),
                FailsWith(kUnusable, "--method"));
    EXPECT_THAT(runTrixel({"sample",
                           from,
                           "--queries",
                           path("q.csv"),
                           "--method",
                           "point",
                           "-o",
                           path("missing/out.csv")}),
                FailsWith(kPath, "missing/out.csv"));
    queries("4,0,0,0,0,0,0\n");
    EXPECT_THAT(sample(from, "point"),
                FailsWith(kUnusable, "q.csv: line 2: column face: expected a face below 4"));
    queries("0,0,zero,0,0,0,0\n");
    EXPECT_THAT(sample(from, "point"), FailsWith(kUnusable, "line 2: column v"));
    write("q.csv", "face,u,v\n");
    EXPECT_THAT(sample(from, "point"), FailsWith(kUnusable, "line 1: expected a column 'uw1'"));
    EXPECT_THAT(files(), ElementsAre("mesh.obj", "new.trixel", "q.csv"));
}

} // namespace
} // namespace trixel::test
