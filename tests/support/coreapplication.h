// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace mb::test {

/// Qt's SQL drivers want an application; one a process, and whoever comes first makes it.
inline void needCoreApplication()
{
    if (QCoreApplication::instance())
        return;
    static int count = 1;
    static char name[] = "test";
    static char *arguments[] = {name, nullptr};
    static QCoreApplication application(count, arguments);
}

/// What descriptors have to tell by now, between two steps of a virtual clock.
inline void serveDescriptors()
{
    QCoreApplication::processEvents();
}

} // namespace mb::test
