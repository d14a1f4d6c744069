// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/control/trialmodel.h"

#include <QWidget>

class QLabel;
class QTableView;

namespace mb {

class CommandButton;
class IconButton;
class Segmented;

/// The notebook of one loop: every trial is kept. A click shows one as B, with Shift as A; its gains can be taken, the best
/// found again, the whole list exported. Does nothing of it by itself.
class TrialList : public QWidget {
    Q_OBJECT
public:
    explicit TrialList(const ThemeSource &theme, QWidget *parent = nullptr);

    void setFamily(const Family *family) { m_model->setFamily(family); }
    void setTrials(std::vector<KeptTrial> trials);
    void setUnits(const DisplayUnits &units) { m_model->setUnits(units); }
    void setLetters(std::int64_t a, std::int64_t b);
    void setRows(int rows);
    /// Takes all the height there is instead of so many rows.
    void setFilling(bool filling);
    /// What is wrong with the notebook; empty: nothing.
    void setTrouble(const QString &text);
    [[nodiscard]] TrialModel &model() { return *m_model; }
    /// The last trial that pushed this motor without a loop, whatever loop is listed; 0: none.
    void setIdentified(std::int64_t number) { m_identified = number; }
    [[nodiscard]] std::int64_t identified() const { return m_identified; }
    [[nodiscard]] QTableView &table() { return *m_table; }

protected:
    void resizeEvent(QResizeEvent *event) override;

Q_SIGNALS:
    void chosen(qint64 number, bool asA);
    void useRequested(qint64 number);
    void deleteRequested(qint64 number);
    void exportRequested();

private:
    QWidget *buildHead();
    void configure();
    void clicked(const QModelIndex &index);
    void openMenu(const QPoint &at);
    void say();
    void fit();
    void fitColumns();
    void fitHead();
    [[nodiscard]] QString widestOf(int column, const QString &most = {}) const;
    [[nodiscard]] qint64 current() const;

    const ThemeSource &m_theme;
    TrialModel *m_model = nullptr;
    QTableView *m_table = nullptr;
    QLabel *m_words = nullptr;
    QLabel *m_empty = nullptr;
    Segmented *m_filter = nullptr;
    CommandButton *m_best = nullptr;
    IconButton *m_export = nullptr;
    QString m_trouble;
    std::int64_t m_identified = 0;
    int m_rows = 5;
    bool m_filling = false;
    QWidget *m_head = nullptr;
};

} // namespace mb
