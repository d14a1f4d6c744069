// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/design/proposalcard.h"
#include "widgets/design/scrollcolumn.h"

#include <optional>

namespace mb {

class EnvelopePanel;
class ModelPanel;
class ProposalList;
class ThemeSource;

/// The left column of the Design page: the model, the sets of gains that stand on it, and the limits. Where the sets would not be in sight
/// without scrolling, the model folds to a line, and where that is not enough the gains of each set too, in the end to those of the chosen one. What then still does not fit scrolls, with the chosen set in sight.
class DesignColumn : public ScrollColumn {
    Q_OBJECT
public:
    DesignColumn(const ThemeSource &theme, QWidget *parent);

    /// Takes them; they were made with content() as their parent.
    void setParts(ModelPanel *model, ProposalList *proposals, EnvelopePanel *envelope);
    /// Another report, once its parts are shown.
    void fitSoon();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void fit();
    void arrange(bool folded, CardDensity density);
    void scrollToChosen();
    [[nodiscard]] bool isInSight() const;

    ModelPanel *m_model = nullptr;
    ProposalList *m_proposals = nullptr;
    QWidget *m_line = nullptr;
    std::optional<bool> m_wantsAll; ///< of the model, by hand
};

} // namespace mb
