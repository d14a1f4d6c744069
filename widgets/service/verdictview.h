// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>
#include <vector>

namespace mb {

/// What a bench says of the unit that is on it, to be read at 3 m.
struct Verdict {
    enum class Kind { Waiting, Working, Passed, Failed, Refused, LeftOut };
    struct Fact {
        QString name;
        QString value; ///< with its unit
        QString note;  ///< "0.10 … 0.40", "read after restart"
    };
    Kind kind = Kind::Waiting;
    QString unit;         ///< serial number, or where it stands
    QString number;       ///< "#36"; empty: none was given
    double seconds = 0.0; ///< 0: not said
    QString step;         ///< working: what it does now
    double share = 0.0;   ///< working: 0 … 1 of the whole
    std::vector<Fact> facts{};
    QString cause; ///< failed, refused: in one line
    QString remedy;
    QString next; ///< "Unplug, connect next"
    QString hint; ///< one dim line below it
};

/// The verdict as word, shape and colour over the whole area; a screen reader hears it as it changes. GUI thread.
class VerdictView : public QWidget {
    Q_OBJECT
public:
    explicit VerdictView(const ThemeSource &theme, QWidget *parent = nullptr);

    void setVerdict(const Verdict &verdict);
    [[nodiscard]] const Verdict &verdict() const { return m_verdict; }
    /// PASS, FAIL, REFUSED, …, translated.
    [[nodiscard]] static QString wordOf(Verdict::Kind kind);
    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    [[nodiscard]] QColor colour() const;
    [[nodiscard]] QColor ground() const;
    void paintShape(QPainter &painter, const QRectF &box) const;
    /// They yield the height that they took.
    int paintHead(QPainter &painter, const QRect &box, double print) const;
    void paintSeconds(QPainter &painter, const QRect &box, double print) const;
    int paintFacts(QPainter &painter, const QRect &box, double print) const;
    void paintCause(QPainter &painter, const QRect &box, double print) const;
    void paintProgress(QPainter &painter, const QRect &box) const;
    void paintFoot(QPainter &painter, const QRect &box, double print) const;
    void announce();

    const ThemeSource &m_theme;
    Verdict m_verdict;
};

} // namespace mb
