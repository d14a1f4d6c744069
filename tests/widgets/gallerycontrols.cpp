// SPDX-License-Identifier: GPL-3.0-or-later
#include "gallery.h"
#include "support/utf8.h"

#include "widgets/common/banner.h"
#include "widgets/common/card.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/searchfield.h"
#include "widgets/common/segmented.h"
#include "widgets/common/sparkline.h"
#include "widgets/common/valuelabel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QProgressBar>
#include <QRadioButton>
#include <QSlider>
#include <QSpinBox>
#include <QTableWidget>
#include <cmath>
#include <utility>

using namespace mb;

namespace {

Card *deviceCard(const ThemeSource &theme, TraceRole role, std::optional<Tone> edge)
{
    auto *card = new Card(theme);
    card->setGlyph(edge == Tone::Danger ? GlyphState::Fault : GlyphState::Moving);
    card->setTitle(s("DMC60C #5"), s("shooter"));
    card->addHeadWidget(badge(s("velocity"), edge == Tone::Danger ? Tone::Danger : Tone::Caution, card));
    card->setEdge(edge);
    auto *values = new QHBoxLayout;
    auto *velocity = new ValueLabel(theme, ValueLabel::Look::Card, s("velocity"), s("rpm"));
    velocity->setValue(formatNumber(-1500));
    auto *current = new ValueLabel(theme, ValueLabel::Look::Card, s("current"), s("A"));
    current->setWidest(s("−88.8"));
    current->setValue(formatNumber(2.4, 1));
    auto *duty = new ValueLabel(theme, ValueLabel::Look::Card, s("duty"), s("%"));
    duty->setWidest(s("−100"));
    for (ValueLabel *label : {velocity, current, duty})
        values->addWidget(label);
    values->addStretch();
    card->body().addLayout(values);
    auto *spark = new Sparkline(theme, role);
    std::deque<double> curve;
    for (int i = 0; i < 100; ++i)
        curve.push_back(i > 60 && i < 66 ? std::nan("") : 1500 * (1 - std::exp(-i / 12.0) * std::cos(i / 6.0)));
    spark->setValues(std::move(curve));
    card->body().addWidget(spark, 1);
    card->foot().addWidget(textLabel(s("120 Hz   lost 0"), TextRole::Caption, Tone::Dim, card));
    card->foot().addStretch();
    card->foot().addWidget(new StateGlyph(theme, GlyphState::Done, card));
    card->foot().addWidget(textLabel(s("no faults"), TextRole::Caption, Tone::Dim, card));
    return card;
}

QTableWidget *table()
{
    auto *view = new QTableWidget(4, 4);
    view->setHorizontalHeaderLabels({s("parameter"), s("value"), s("unit"), s("state")});
    view->verticalHeader()->hide();
    view->setShowGrid(false);
    view->verticalHeader()->setDefaultSectionSize(30);
    for (int row = 0; row < 4; ++row) {
        const QStringList texts{s("P gain"), s("1.1650"), s("throttle/(cnt/100 ms)"), s("RAM, not in flash")};
        for (int column = 0; column < 4; ++column)
            view->setItem(row, column, new QTableWidgetItem(texts[column]));
        view->item(row, 1)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    view->item(0, 0)->setCheckState(Qt::Checked);
    view->item(1, 0)->setCheckState(Qt::Unchecked);
    view->horizontalHeader()->setStretchLastSection(true);
    view->selectRow(1);
    view->setSelectionBehavior(QAbstractItemView::SelectRows);
    return view;
}

QHBoxLayout *fieldRow(const ThemeSource &theme)
{
    auto *row = new QHBoxLayout;
    auto *search = new SearchField(theme, s("Search 55 parameters"));
    search->setKeyHint(s("Ctrl+F"));
    auto *found = new SearchField(theme, s("Search"));
    found->setText(s("link:can0"));
    found->setResult(s("1 204 of 1 391 shown"));
    auto *combo = new QComboBox;
    combo->addItems({s("Step 0 ▸ 1500 rpm"), s("Ramp")});
    auto *field = new QLineEdit(s("40000"));
    field->setProperty("state", s("error"));
    auto *spin = new QDoubleSpinBox;
    spin->setValue(12.5);
    auto *off = new QLineEdit(s("disabled"));
    off->setEnabled(false);
    for (QWidget *widget : std::initializer_list<QWidget *>{search, found, combo, field, spin, off})
        row->addWidget(widget);
    return row;
}

QHBoxLayout *buttonRow(const ThemeSource &theme)
{
    auto *row = new QHBoxLayout;
    auto *primary = new CommandButton(theme, Symbol::Play, s("Write and run"));
    primary->setPrimary(true);
    primary->setKeyHint(s("F5"));
    auto *plain = new CommandButton(theme, Symbol::Wand, s("Autotune"));
    plain->setKeyHint(s("F6"));
    auto *off = new CommandButton(theme, Symbol::Play, s("Start"));
    off->setEnabled(false);
    auto *offPrimary = new CommandButton(theme, s("Write 3"));
    offPrimary->setPrimary(true);
    offPrimary->setEnabled(false);
    auto *toggle = new QPushButton(s("Linked"));
    toggle->setCheckable(true);
    toggle->setChecked(true);
    auto *icon = new IconButton(theme, Symbol::Fit, s("Fit time and value"));
    auto *checked = new IconButton(theme, Symbol::Cursors, s("Cursors"));
    checked->setCheckable(true);
    checked->setChecked(true);
    for (QWidget *widget : std::initializer_list<QWidget *>{
             primary, plain, off, offPrimary, toggle, linkButton(s("Back to best"), nullptr), icon, checked})
        row->addWidget(widget);
    auto *segments = new Segmented(s("Filter"), {s("All 55"), s("Changed 14"), s("Edited 4"), s("Errors 1")});
    segments->setSegmentEnabled(3, false);
    row->addWidget(segments);
    row->addStretch();
    return row;
}

QHBoxLayout *choiceRow()
{
    auto *row = new QHBoxLayout;
    auto *check = new QCheckBox(s("Limiting enabled"));
    check->setChecked(true);
    auto *unchecked = new QCheckBox(s("Average of 4"));
    auto *radio = new QRadioButton(s("Velocity"));
    radio->setChecked(true);
    auto *radioOff = new QRadioButton(s("Position"));
    auto *slider = new QSlider(Qt::Horizontal);
    slider->setValue(45);
    auto *progress = new QProgressBar;
    progress->setValue(61);
    auto *done = new QProgressBar;
    done->setValue(100);
    setStyleProperty(*done, "tone", s("ok"));
    for (QWidget *widget : std::initializer_list<QWidget *>{check, unchecked, radio, radioOff, slider, progress, done})
        row->addWidget(widget);
    return row;
}

QHBoxLayout *badgeRow(const ThemeSource &theme)
{
    auto *row = new QHBoxLayout;
    row->addWidget(new SectionLabel(s("Trials, flash pages")));
    row->addWidget(badge(s("dialect F"), Tone::Dim, nullptr));
    row->addWidget(badge(s("boot"), Tone::Caution, nullptr));
    row->addWidget(badge(s("fix first"), Tone::Danger, nullptr));
    row->addWidget(badge(s("LOST 0"), Tone::Ok, nullptr));
    row->addWidget(badge(s("B"), Tone::Accent, nullptr));
    for (const Tone tone : {Tone::Text, Tone::Dim, Tone::Faint, Tone::Accent, Tone::Ok, Tone::Caution, Tone::Danger})
        row->addWidget(textLabel(s("text"), TextRole::Body, tone, nullptr));
    row->addWidget(textLabel(s("0x0006199A"), TextRole::Raw, Tone::Dim, nullptr));
    row->addWidget(textLabel(s("Title"), TextRole::Title, Tone::Text, nullptr));
    auto *line = new ValueLabel(theme, ValueLabel::Look::Line, s("bus"), s("V"));
    line->setWidest(s("88.88"));
    line->setValue(formatNumber(12.43, 2));
    row->addWidget(line);
    auto *stale = new ValueLabel(theme, ValueLabel::Look::Line, s("case"), s("°C"));
    stale->setWidest(s("88.8"));
    stale->setValue(s("34.5"));
    stale->setStale(true);
    row->addWidget(stale);
    row->addStretch();
    return row;
}

} // namespace

QWidget *controlsPage(const ThemeSource &theme)
{
    auto *page = new QWidget;
    auto *column = new QVBoxLayout(page);
    auto *banner = new Banner(theme, BannerKind::Caution,
        s("can0 makes receive errors: 38 stuff errors in 10 s. TEC 0, REC 41."),
        s("Likely a missing 120 Ω end resistor or a stub longer than 0.3 m near #7. Bus load is fine (6 %)."));
    banner->setAction(s("How to check"));
    column->addWidget(banner);
    column->addWidget(
        new Banner(theme, BannerKind::Ok, s("Safe to unplug"), s("The unit would stay in its bootloader and resume.")));
    column->addLayout(buttonRow(theme));
    column->addLayout(fieldRow(theme));
    column->addLayout(choiceRow());
    column->addLayout(badgeRow(theme));
    auto *row = new QHBoxLayout;
    row->addWidget(deviceCard(theme, TraceRole::Velocity, Tone::Accent), 1);
    row->addWidget(deviceCard(theme, TraceRole::Position, {}), 1);
    row->addWidget(deviceCard(theme, TraceRole::Current, Tone::Danger), 1);
    row->addWidget(table(), 2);
    column->addLayout(row, 1);
    return page;
}
