// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/axischoice.h"
#include "widgets/parameters/comparisonbox.h"
#include "widgets/parameters/parameterfilter.h"

namespace mb {

class SearchField;
class WrapLayout;

/// Between head and table: which parameters are shown, and what they are compared with.
class ParameterTools : public QWidget {
    Q_OBJECT
public:
    ParameterTools(
        const ThemeSource &theme, Workbench &workbench, Selection &selection, ParameterModel &model, QWidget *parent);

    [[nodiscard]] ParameterFilter filter() const;
    [[nodiscard]] AxisChoice &axes() { return *m_axes; }
    [[nodiscard]] ComparisonBox &comparison() { return *m_comparison; }
    void showCounts(const ParameterCounts &counts, int shownRows);
    /// Of all, those that are edited.
    void chooseEdited();
    /// The cursor goes into the search field.
    void search();
    /// `lead` stands before the search then, and has the comparison in its menu; nullptr: there is room for both. Takes it.
    void setLead(QWidget *lead);

Q_SIGNALS:
    void filterChanged();
    /// Enter in the search field.
    void searchEnded();

protected:
    void resizeEvent(QResizeEvent *) override { fit(); }
    bool event(QEvent *event) override;

private:
    void fit();

    const ThemeSource &m_theme;
    WrapLayout *m_row = nullptr;
    QWidget *m_lead = nullptr;
    SearchField *m_search = nullptr;
    Segmented *m_segments = nullptr;
    ComparisonBox *m_comparison = nullptr;
    AxisChoice *m_axes = nullptr;
};

} // namespace mb
