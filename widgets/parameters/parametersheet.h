// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/changespanel.h"
#include "widgets/parameters/parameterfoot.h"
#include "widgets/parameters/parameterview.h"

#include <QSplitter>

namespace mb {

/// The table with its foot, and what is staged beside it, or below it where there is less room. Where names would have to be cut for it
/// it comes only while there is something to write.
class ParameterSheet : public QSplitter {
    Q_OBJECT
public:
    ParameterSheet(const ThemeSource &theme, Workbench &workbench, ParameterModel &model, QWidget *parent);

    [[nodiscard]] ParameterView &view() { return *m_view; }
    [[nodiscard]] ParameterFoot &foot() { return *m_foot; }
    [[nodiscard]] ChangesPanel &changes() { return *m_changes; }
    /// Below it.
    void setCompact(bool compact);
    /// False: values of a file, which has no unit.
    void setWritable(bool writable);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void fit();

    const ThemeSource &m_theme;
    ParameterView *m_view = nullptr;
    ParameterFoot *m_foot = nullptr;
    ChangesPanel *m_changes = nullptr;
    bool m_compact = false;
    bool m_writable = true;
};

} // namespace mb
