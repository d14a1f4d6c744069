// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/windowtests.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

#include <cstdio>
#include <map>

namespace mb::test {
namespace {

std::map<std::string, RegisteredTest::Make> &registered()
{
    static std::map<std::string, RegisteredTest::Make> all;
    return all;
}

int listTests(const char *program)
{
    std::fprintf(stderr, "usage: %s NAME [options of QtTest]; NAME is one of\n", program);
    for (const auto &[name, make] : registered())
        std::fprintf(stderr, "  %s\n", name.c_str());
    return 2;
}

} // namespace

std::string nameOfTest(const std::string &file)
{
    const std::size_t begin = file.find_last_of('/') + 1;
    const std::string stem = file.substr(begin, file.find_last_of('.') - begin);
    return stem.starts_with("tst_") ? stem.substr(4) : stem;
}

RegisteredTest::RegisteredTest(const char *file, Make make)
{
    registered().emplace(nameOfTest(file), make);
}

} // namespace mb::test

int main(int argc, char **argv)
{
    using namespace mb::test;
    const auto chosen = argc > 1 ? registered().find(argv[1]) : registered().end();
    if (chosen == registered().end())
        return listTests(argv[0]);
    std::vector<char *> rest{argv[0]};
    rest.insert(rest.end(), argv + 2, argv + argc);
    int count = static_cast<int>(rest.size());
    rest.push_back(nullptr);
    const QTemporaryDir home; // what the program keeps goes with the test
    for (const char *const folder : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
        qputenv(folder, home.filePath(QLatin1String(folder)).toUtf8());
    QApplication application(count, rest.data());
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi, true);
    const auto test = chosen->second();
    return QTest::qExec(test.get(), count, rest.data());
}
