// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/base/french/translation.hpp"

namespace torsor {

/// Why a motion with contacts ended, and what there is to say of it.
constexpr Translation french_of_contacts[] = {
    {"stopped because the observer returned false", "arrêté par l'observateur"},
    {"no regimes fulfil the laws of contact: the equations of rigid bodies have no solution here (Painlevé)",
     "aucun régime ne vérifie les lois de contact : les équations des solides rigides n'ont pas de solution ici (Painlevé)"},
    {"a contact that slides jams: the equations of rigid bodies become singular here, and what follows is not determined (Painlevé)",
     "un contact qui glisse s'arc-boute : les équations des solides rigides deviennent singulières ici, et la suite n'est pas "
     "déterminée (Painlevé)"},
    {"the impact law gave energy: choose another, or a smaller restitution",
     "la loi de choc a fourni de l'énergie : en choisir une autre, ou une restitution plus petite"},
    {"a contact starts below its surface: begin where every gap is at least zero",
     "un contact part de dessous sa surface : partir d'un état où aucune distance n'est négative"},
    {"the loops cannot be closed near the start: begin nearer to a state in which they are",
     "les boucles ne peuvent pas être fermées près du départ : partir plus près d'un état où elles le sont"},
    {"a contact's rule is impossible: friction and bounds finite and at least 0, static ones at least those of sliding, "
     "restitution from 0 to 1, at most two tangents, pressed by an earlier contact with a normal",
     "la loi d'un contact est impossible : frottements et bornes sont finis et non négatifs, ceux d'adhérence au moins égaux à "
     "ceux de glissement, la restitution est entre 0 et 1, il y a deux tangentes au plus, et un contact antérieur avec une "
     "normale le presse"},
    {"there are too many events for their limit: raise it, or look for regimes that alternate without end",
     "il y a trop d'événements pour leur limite : l'augmenter, ou chercher des régimes qui alternent sans fin"},
    {"the integration between events failed, see its own status",
     "l'intégration entre événements a échoué, voir son propre état"},
    {"the energetic law of impact is one of a single contact, and several touch: choose another law",
     "la loi de choc énergétique est celle d'un seul contact, et plusieurs se touchent : choisir une autre loi"},
    {"no impulses fulfil the law of impact, or its collisions have no end: choose another law, or a smaller restitution",
     "aucune percussion ne vérifie la loi de choc, ou ses collisions sont sans fin : choisir une autre loi, ou une "
     "restitution plus petite"},
    {"no regimes were found that fulfil the laws of contact, and they are too many to try all: begin beside such a state, or "
     "change a coefficient of friction",
     "aucun régime trouvé ne vérifie les lois de contact, et ils sont trop nombreux pour être tous essayés : partir à côté "
     "d'un tel état, ou changer un coefficient de frottement"},
    {"the constraints of loops lose rank here, a change point, where branches of a loop meet: the motion does not pass it",
     "les liaisons des boucles perdent leur rang ici, un point de bifurcation, où des branches d'une boucle se rencontrent : le mouvement ne "
     "le passe pas"},
    {"a contact has no single point or normal here, as the lowest point of a disc that lies flat, or its gap falls by a jump, "
     "as at a wall, or the rate of its gap does, as in a valley with a kink, for which no law gives an impulse: begin beside "
     "such a state, round the surface off, or describe it by points",
     "un contact n'a pas de point ou de normale unique ici, comme le point le plus bas d'un disque à plat, ou sa distance "
     "diminue d'un saut, comme devant un mur, ou sa vitesse d'écartement, comme au fond d'un angle, pour quoi aucune loi ne "
     "donne de percussion : partir à côté d'un tel état, arrondir la surface, ou la décrire par des points"},
    {"the motion is asked for what cannot be: its end is not before its start, steps are above 0, theta is from 0 to 1, touch, "
     "at_rest and accumulation are at least 0, the law is one of the four, and none is NaN",
     "le mouvement demandé est impossible : sa fin ne précède pas son départ, les pas sont positifs, theta est entre 0 et 1, touch, "
     "at_rest et accumulation ne sont pas négatifs, la loi est l'une des quatre, et aucun n'est NaN"},
    {"the start has a quaternion of zeros, which is no attitude: give one of norm 1",
     "le départ a un quaternion nul, qui n'est pas une attitude : en donner un de norme 1"},
    {"the mechanism has more numbers or contacts than there is room for: give ContactRun more",
     "le mécanisme a plus de nombres ou de contacts que la place prévue : en donner plus à ContactRun"},
    {"the motion was not started, or its state was changed since: call start first",
     "le mouvement n'a pas commencé, ou son état a été changé depuis : appeler start d'abord"},
    {"reached the end time", "a atteint l'instant final"},
    {"the integration between events failed: {}", "l'intégration entre événements a échoué : {}"},
    {"the accelerations, or positions that fulfil the constraints, could not be found",
     "ni accélérations ni positions qui vérifient les liaisons n'ont pu être trouvées"},
    {"unusable options: times and the state at the start must be finite, a fixed step positive, tolerances not negative, not "
     "both zero, and a relative tolerance at least four roundings of the scalar",
     "options inutilisables : instants et état initial sont finis, un pas fixe est positif, les tolérances ne sont pas "
     "négatives, ni nulles toutes deux, et la tolérance relative vaut au moins quatre arrondis du nombre"},
    {"the step fell below the resolution of time: loosen the tolerances, look for a discontinuity, or take an implicit method "
     "where a mode is fast",
     "le pas est tombé sous la résolution du temps : relâcher les tolérances, chercher une discontinuité, ou prendre une "
     "méthode implicite si un mode est rapide"},
    {"the step limit was met: raise it or loosen the tolerances",
     "la limite du nombre de pas est atteinte : l'augmenter ou relâcher les tolérances"},
    {"the model could not be evaluated", "le modèle n'a pas pu être évalué"},
    {"the equations of an implicit step did not converge: reduce the step, or choose Newton's method for them",
     "les équations d'un pas implicite n'ont pas convergé : réduire le pas, ou choisir la méthode de Newton"},
    {"the model lacks the structure that the method asks for (see the method's documentation)",
     "le modèle n'a pas la structure que demande la méthode (voir la documentation de la méthode)"},
    {"stopped at an event", "arrêté à un événement"},
    {"the events of a guard accumulate at a finite time: go on from there with the equations of rest on it",
     "les événements d'un indicateur s'accumulent en un temps fini : continuer de là avec les équations de repos"},
    {"the state lies beyond a barrier at the start or after a reset: begin where its guard is not negative",
     "l'état est au-delà d'une barrière au départ ou après un saut : partir d'un état où l'indicateur n'est pas négatif"},
    {"a guard is not finite, oscillates too fast within a step, or crosses zero on the method's interpolant but not on its "
     "steps: limit the step",
     "un indicateur n'est pas fini, oscille trop vite dans un pas, ou passe par zéro entre les pas de la méthode mais pas à leurs "
     "bouts : borner le pas"},
    {"the limit of events was met: raise it", "la limite du nombre d'événements est atteinte : l'augmenter"},
    {"{} at t = {:.9g} s", "{} à t = {:.9g} s"},
    {"forces and impulses of contacts fulfil the laws of contact to {:.1g} of the largest",
     "les forces et les percussions de contact vérifient les lois de contact à {:.1g} près de la plus grande"},
    {"at t = {:.9g} s the mechanism is at a dead centre of '{}', where the loops hold what it acts on and its force is not "
     "determined: end the motion before (--to), or start elsewhere (--initial)",
     "à t = {:.9g} s le mécanisme est à un point mort de « {} », où les boucles retiennent ce sur quoi il agit et où sa force n'est pas "
     "déterminée : arrêter le mouvement avant (--to), ou partir d'ailleurs (--initial)"},
    {"the model was evaluated", "le modèle a été évalué"},
    {"the model is singular: the mass matrix or the constraints lose rank (a change point, where branches of a closed loop meet; "
     "angles at the singular position of their chart; a freedom without mass; see docs/constraints.md)",
     "le modèle est singulier : la matrice de masse ou les liaisons perdent du rang (un point de bifurcation, où se rejoignent les "
     "branches d'une boucle fermée ; des angles à la position singulière de leur carte ; une liberté sans masse ; voir "
     "docs/constraints.md)"},
    {"the model gives a value that is not finite", "le modèle donne une valeur qui n'est pas finie"},
    {"; regimes until then: {}", " ; régimes jusque-là : {}"},
    {"; regimes found: none", " ; régimes trouvés : aucun"},
    {"; state: {}", " ; état : {}"},
    {"one event", "un événement"},
    {"{} events", "{} événements"},
    {"one decision", "une décision"},
    {"{} decisions", "{} décisions"},
    {"in {} several motions fulfil the laws of contact: one was taken",
     "dans {}, plusieurs mouvements vérifient les lois de contact : l'un d'eux est pris"},
    {"at {} the sequential law of impact depends on the order of contacts: another one gives other velocities",
     "à {}, la loi de choc séquentielle dépend de l'ordre des contacts : un autre donne d'autres vitesses"},
    {"in {} reactions are indeterminate: other ones give the same motion",
     "dans {}, des réactions sont indéterminées : d'autres donnent le même mouvement"},
};

}  // namespace torsor
