// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generator/base/french/translation.hpp"

namespace torsor {

/// Equilibrium, theorems, screws, unknowns.
constexpr Translation french_of_statics[] = {
    // Equilibrium
    {"With {}.", "Avec {}."},
    {"Equations of equilibrium", "Équations d'équilibre"},
    {"constraint", "équation de liaison"},
    {"the forces at rest do not derive from U + T0: T depends on time explicitly",
     "les efforts au repos ne dérivent pas de U + T0 : T dépend explicitement du temps"},
    {"the forces at rest do not derive from U + T0: {} act at rest",
     "les efforts au repos ne dérivent pas de U + T0 : au repos agissent {}"},
    {"Lejeune-Dirichlet presupposes that {} dissipate and that inputs are zero",
     "le théorème de Lejeune-Dirichlet suppose une dissipation par {} et des commandes nulles"},
    {"Second derivatives of {} at any configuration", "Dérivées secondes de {} en une configuration quelconque"},
    {"Where it is positive definite a rest is stable (Lejeune-Dirichlet); elsewhere the criterion cannot conclude. Name a rest by "
     "--about for the conditions there.",
     "Si elle est définie positive, un équilibre est stable (Lejeune-Dirichlet) ; sinon le critère ne conclut pas. Nommer un "
     "équilibre par --about pour y écrire les conditions."},
    {"Lejeune-Dirichlet cannot conclude: the scene has constraints; describe it with independent coordinates, or let the runtime "
     "project the second derivatives on the tangent space.",
     "Le théorème de Lejeune-Dirichlet ne conclut pas : il reste des équations de liaison ; prendre des paramètres indépendants, "
     "ou laisser la bibliothèque d'exécution projeter les dérivées secondes sur l'espace tangent."},
    {"Lejeune-Dirichlet cannot conclude: {}.", "Le théorème de Lejeune-Dirichlet ne conclut pas : {}."},
    {"At {}", "En {}"},
    {"must hold for a rest", "nécessaire à l'équilibre"},
    {"Every equation of equilibrium holds: a rest, whatever the parameters.",
     "Toutes les équations d'équilibre sont vérifiées : un équilibre, quels que soient les paramètres."},
    {"Lejeune-Dirichlet", "Théorème de Lejeune-Dirichlet"},
    {"H: second derivatives of {} there.", "H : dérivées secondes de {} en ce point."},
    {"Stable where H is positive definite, else it cannot conclude (a condition that always holds is left out):",
     "Stable si H est définie positive, sinon on ne conclut pas (une condition toujours vérifiée est omise) :"},
    {"H is positive definite", "H est définie positive"},
    {"With the scene's values this is no rest: nothing is concluded.",
     "Avec les valeurs données, ce n'est pas un équilibre : on ne conclut pas."},
    {"With the scene's values: {}.", "Avec les valeurs données : {}."},
    {"cannot conclude: {}", "on ne conclut pas : {}"},
    {"cannot conclude: pivot {} of the Hessian of -(U + T0) is {}{}",
     "on ne conclut pas : le pivot {} de la matrice des dérivées secondes de -(U + T0) vaut {}{}"},
    {", zero within rounding", ", nul aux arrondis près"},
    {", not a minimum", ", ce n'est pas un minimum"},
    {"stable: -(U + T0) has a strict minimum", "stable : -(U + T0) a un minimum strict"},
    {"Routh and Hurwitz, linearised equations", "Routh et Hurwitz, équations linéarisées"},
    {"Cannot conclude here: the scene has constraints; the kernel linearisation reduces them, and the runtime finds the "
     "eigenvalues.",
     "On ne conclut pas ici : il reste des équations de liaison ; le noyau linearisation les réduit, et la bibliothèque d'exécution trouve les "
     "valeurs propres."},
    {"Not written: {} freedoms, and formulas are for {} at most; the runtime finds the eigenvalues.",
     "Non écrit : {} degrés de liberté, et les formules vont jusqu'à {} ; la bibliothèque d'exécution trouve les valeurs propres."},
    {"Not written: {}.", "Non écrit : {}."},
    {"det(M s^2 + C s + K) has the coefficients", "det(M s^2 + C s + K) a pour coefficients"},
    {"Cannot conclude that it is stable: a determinant of Hurwitz vanishes whatever the parameters, so that some root has Re s >= "
     "0.",
     "On ne conclut pas à la stabilité : un déterminant de Hurwitz est nul quels que soient les paramètres, une racine a donc Re s "
     ">= 0."},
    {"All roots have Re s < 0, and the rest is asymptotically stable, exactly where",
     "Toutes les racines ont Re s < 0, et l'équilibre est asymptotiquement stable, si et seulement si"},
    {"all roots have Re s < 0", "toutes les racines ont Re s < 0"},
    {"With the scene's values: cannot conclude, a condition is an equality, if this is a rest.",
     "Avec les valeurs données : on ne conclut pas, une condition est une égalité, si c'est un équilibre."},
    {"With the scene's values: asymptotically stable, if this is a rest.",
     "Avec les valeurs données : asymptotiquement stable, si c'est un équilibre."},
    {"With the scene's values: unstable, a root has Re s > 0, if this is a rest.",
     "Avec les valeurs données : instable, une racine a Re s > 0, si c'est un équilibre."},
    {"With the scene's values: unstable, for a coefficient is negative, if this is a rest.",
     "Avec les valeurs données : instable, car un coefficient est négatif, si c'est un équilibre."},
    {"Cannot conclude: a condition reads 0 > 0 whatever the parameters.",
     "On ne conclut pas : une condition se lit 0 > 0 quels que soient les paramètres."},
    {"Whatever the parameters, {}.", "Quels que soient les paramètres, {}."},
    // Theorems
    {"resultant", "théorème de la résultante"},
    {"moment", "théorème du moment"},
    {", seen from {}", ", vu de {}"},
    {" at {}", " en {}"},
    {"Energy theorem for {}{}", "Théorème de l'énergie cinétique pour {}{}"},
    {"power of the actions from outside, in W", "puissance des efforts extérieurs, en W"},
    {"power of the actions between the bodies, in W", "puissance des efforts intérieurs, en W"},
    {"Newton-Euler for {}: {}{} along {} of {}{}", "Principe fondamental pour {} : {}{} suivant {} de {}{}"},
    {"No unknown of a joint enters: an equation of motion.", "Aucune inconnue de liaison n'intervient : une équation du mouvement."},
    {"Unknown: {}.", "Inconnues : {}."},
    {"[joint X], Y, Z, L, M, N: force and moment on the body that the joint carries, at the origin of that body's frame, along the "
     "axes of the joint's first frame that moves.",
     "[liaison X], Y, Z, L, M, N : résultante et moment sur le solide porté par la liaison, à l'origine du repère de ce solide, "
     "suivant les axes du premier repère mobile de la liaison."},
    {"Multipliers are those of the scene's constraints.", "Les multiplicateurs sont ceux des équations de liaison."},
    {"of joint {} only {} is unknown: what works in the joint gives the rest",
     "de la liaison {}, seule {} est inconnue : ce qui travaille dans la liaison donne le reste"},
    {"what motors, springs and dampers do along the freedoms of joint {} is in its named components",
     "les efforts des moteurs, ressorts et amortisseurs suivant les degrés de liberté de la liaison {} sont dans ses composantes "
     "nommées"},
    // Screws
    {"Screws of {} at {} along the axes of {}{}", "Torseurs de {} en {} suivant les axes de {}{}"},
    {"Twist: angular velocity [rad/s], velocity of the body's own point [m/s].",
     "Torseur cinématique : vitesse de rotation [rad/s], vitesse du point lié au solide [m/s]."},
    {"Momentum screw: [kg m/s], [N m s].", "Torseur cinétique : [kg m/s], [N m s]."},
    {"Dynamic screw: [N], [N m].", "Torseur dynamique : [N], [N m]."},
    {"Kinetic energy [J].", "Énergie cinétique [J]."},
    // Unknowns and equations
    {"none", "aucun"},
    {"Unknowns and equations of {}", "Inconnues et équations de {}"},
    {"unknown coordinates: {}", "paramètres inconnus : {}"},
    {"driven by a law of time: {}", "imposés par une loi du temps : {}"},
    {"released, held at zero: {}", "libérés, maintenus nuls : {}"},
    {"constraints: {}", "équations de liaison : {}"},
    {"{}, non-holonomic", "{}, non holonome"},
    {"{}, holonomic", "{}, holonome"},
    {"of these, constraints that repeat others: {}", "dont équations de liaison qui en répètent d'autres : {}"},
    {"degrees of freedom: {}", "degrés de liberté : {}"},
    {"joint {} on {}: {}", "liaison {} sur {} : {}"},
    {"nothing unknown", "rien d'inconnu"},
    {"Newton-Euler", "Principe fondamental de la dynamique"},
    {"{} equation{}", "{} équation{}"},
    {"{} unknown{}", "{} inconnue{}"},
    {"{} component{}", "{} composante{}"},
    {"{} multiplier{}", "{} multiplicateur{}"},
    {"{} acceleration{}", "{} accélération{}"},
    {"1 body", "1 solide"},
    {"{} bodies", "{} solides"},
    {"{}: 6 for each of {} and {} of constraint", "{} : 6 pour chacun de {} et {} de liaison"},
    {"{}: {} in joints, {}, {}", "{} : {} de liaison, {}, {}"},
    {"{} more: joints tied by formulas of shared coordinates transmit power without loss",
     "{} de plus : des liaisons dépendant de mêmes paramètres transmettent la puissance sans perte"},
    {"{} indeterminate: constraints that repeat others share their forces in a way that no motion tells",
     "{} indéterminées : le partage des efforts entre équations de liaison répétées ne se lit sur aucun mouvement"},
    {"Lagrange", "Lagrange"},
    {"{}: {} of motion and {} of constraint, for {} and {}", "{} : {} du mouvement et {} de liaison, pour {} et {}"},
    {"{} of constraints that repeat others, taken as zero", "{} d'équations de liaison répétées, pris nuls"},
    {"{} more, of the released coordinates, for the reactions against them",
     "{} de plus, des paramètres libérés, pour les réactions correspondantes"},
    {"The choice", "Le choix"},
    {"with {} independent instead of {} coordinates there is no multiplier, and what the constraints transmit stays unknown",
     "avec {} paramètres indépendants au lieu de {}, il n'y a pas de multiplicateur, et les efforts de liaison restent inconnus"},
    {"each component in a joint comes from Newton-Euler for isolated bodies, or from one more released coordinate and its "
     "equation",
     "chaque composante d'une liaison vient du principe fondamental appliqué à des solides isolés, ou d'un paramètre libéré de "
     "plus et de son équation"},
};

}  // namespace torsor
