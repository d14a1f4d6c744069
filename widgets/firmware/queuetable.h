// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/firmware/queuemodel.h"

#include <QWidget>

#include <array>
#include <optional>

class QCheckBox;
class QTableView;

namespace mb {

class ThemeSource;

/// The units of a queue, one line each, below a box that ticks all of them. GUI thread.
class QueueTable : public QWidget {
    Q_OBJECT
public:
    explicit QueueTable(const ThemeSource &theme, QWidget *parent);

    [[nodiscard]] QueueModel &model() const { return *m_model; }
    [[nodiscard]] QTableView &view() const { return *m_view; }
    /// The line that is selected; nullptr: none is. The focus alone, which comes to the first line by itself, selects nothing.
    [[nodiscard]] const QueueLine *chosen() const;
    /// What the units are, as in "Every DMC60C"; without it there is no box.
    void setKind(const QString &title);
    /// The box after the ticks have changed; while units are served it cannot be used.
    void followTicks(bool running);

Q_SIGNALS:
    void chosenChanged();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void buildView(const ThemeSource &theme);
    void fitColumns();

    const ThemeSource &m_theme;
    std::array<int, QueueModel::Columns> m_needed{}; ///< pixels; never less, so that nothing moves to and fro
    QCheckBox *m_every = nullptr;
    QueueModel *m_model = nullptr;
    QTableView *m_view = nullptr;
    std::optional<QueueLine> m_chosen; ///< while the model is made anew: other units come and go beside it
};

} // namespace mb
