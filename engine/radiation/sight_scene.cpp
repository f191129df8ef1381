#include "engine/radiation/sight_scene.h"

namespace bask {

std::size_t SightScene::add(SightFigure figure) {
    m_figures.push_back(std::move(figure));
    m_relations.clear();
    return m_figures.size() - 1;
}

std::size_t SightScene::clipped(std::size_t figure, const HalfSpace& space) {
    SightFigure part = m_figures[figure];
    return part.clip(space) ? add(std::move(part)) : figure;
}

const SightScene::Relation& SightScene::relation(std::size_t of, std::size_t to) const {
    m_relations.resize(m_figures.size() * m_figures.size());
    std::unique_ptr<Relation>& relation = m_relations[of * m_figures.size() + to];
    if (!relation) {
        relation = std::make_unique<Relation>();
        const SightFigure& own = m_figures[of];
        const SightFigure& frame = m_figures[to];
        const auto inFrame = [&frame](const Eigen::Vector3d& v) {
            return Eigen::Vector3d(frame.e1.dot(v), frame.e2.dot(v), frame.n.dot(v));
        };
        relation->origin = inFrame(own.origin - frame.origin);
        relation->e1 = inFrame(own.e1);
        relation->e2 = inFrame(own.e2);
        for (const Eigen::Vector2d& corner : own.corners())
            relation->corners.emplace_back(relation->origin + corner.x() * relation->e1 +
                                           corner.y() * relation->e2);
        for (const SightFigure::Chain& chain : own.chains()) {
            const Eigen::Vector2d middle = chain.middle();
            relation->chains.emplace_back(
                relation->origin + middle.x() * relation->e1 + middle.y() * relation->e2, chain.radius());
        }
    }
    return *relation;
}

} // namespace bask
