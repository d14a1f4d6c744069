// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/monitor/filterterm.h"

#include <QCoreApplication>
#include <QString>

namespace mb {

/// Reads one word of a filter, such as device:5,7.
class FrameTermReader {
    Q_DECLARE_TR_FUNCTIONS(FrameTermReader)
public:
    explicit FrameTermReader(const QString &word);
    /// Means nothing when there is a problem.
    [[nodiscard]] const FilterTerm &term() const { return m_term; }
    /// The opposite is meant, as `dir:rx` is not `dir:tx`.
    [[nodiscard]] bool isTurned() const { return m_turned; }
    /// What is wrong with it; empty when all is well.
    [[nodiscard]] const QString &problem() const { return m_problem; }
    /// The language on one page, as rich text.
    [[nodiscard]] static QString help();

private:
    using Test = FilterTerm::Test;

    void readField(const QString &word);
    void readKeyed(const QString &key, const QString &value);
    void readIds(const QString &value);
    void readDevices(const QString &value);
    void readData(const QString &value);
    void readFamilies(const QString &value);
    void readState(const QString &key, const QString &value);
    void fail(const QString &problem) { m_problem = problem; }

    FilterTerm m_term;
    bool m_turned = false;
    QString m_problem;
};

} // namespace mb
