// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTest>

#include <memory>
#include <string>

namespace mb::test {

/// A QtTest class that a test program can run: `PROGRAM NAME [options of QtTest]`, where tst_NAME.cpp is its file. One program
/// holds the tests of a folder, so that libraries and resources are linked once; CTest starts it anew for each NAME.
struct RegisteredTest {
    using Make = std::unique_ptr<QObject> (*)();
    RegisteredTest(const char *file, Make make);
};

/// The name of a test from the path of its file: "tests/widgets/tst_lamp.cpp" is "lamp".
[[nodiscard]] std::string nameOfTest(const std::string &file);

} // namespace mb::test

// What is waited for comes at once on a quick machine, and later on one that others use: the limit only ends what hangs.
#undef QTRY_VERIFY
#define QTRY_VERIFY(expression) QTRY_VERIFY_WITH_TIMEOUT((expression), 60'000)
#undef QTRY_COMPARE
#define QTRY_COMPARE(expression, expected) QTRY_COMPARE_WITH_TIMEOUT((expression), (expected), 60'000)

#define MB_JOINED_NAME(name, number) name##number
#define MB_NUMBERED_NAME(name, number) MB_JOINED_NAME(name, number)

/// Stands where QTEST_MAIN would; once in a file.
#define MB_WINDOW_TEST(Class)                                                                                          \
    static const mb::test::RegisteredTest MB_NUMBERED_NAME(registeredTest, __COUNTER__)(                               \
        __FILE__, [] { return std::unique_ptr<QObject>(std::make_unique<Class>()); })
