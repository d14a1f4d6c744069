// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/utf8.h"
#include "tunebench.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLineEdit>
#include <QTest>

namespace mb::test {

/// Ways a hand has with the page.

inline void type(QLineEdit *field, const char *text)
{
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, s(text));
}

inline void pick(QComboBox *box, int row)
{
    box->setCurrentIndex(row);
    Q_EMIT box->activated(row);
}

inline void click(TuneBench &bench, const char *name)
{
    auto *button = bench.find<QAbstractButton>(name);
    QVERIFY2(button, name);
    button->click();
}

/// A button of a choice of slots.
inline QAbstractButton *slot(TuneBench &bench, const char *choice, int number)
{
    const auto *row = bench.find<QWidget>(choice);
    const auto buttons = row->findChildren<QAbstractButton *>();
    return buttons.at(number);
}

inline QString problemOf(TuneBench &bench)
{
    return bench.page->status().cause + s(" | ") + bench.page->status().remedy;
}

} // namespace mb::test
