// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/base/french/translation.hpp"

namespace torsor {

/// Equations of motion, their derivation, contacts and first integrals.
constexpr Translation french_of_equations[] = {
    // Symbols
    {"Parameters", "Paramètres constants"},
    {"Coordinates", "Paramètres du mouvement"},
    {"Inputs", "Commandes"},
    {"Multipliers", "Multiplicateurs de Lagrange"},
    {"Definitions", "Définitions"},
    {"Laws of time", "Lois du temps"},
    {"Roots", "Racines"},
    {"given at run time", "donné à l'exécution"},
    {"released: held at zero by the joint, its reaction is asked for",
     "libéré : maintenu nul par la liaison, dont on demande la réaction"},
    {"component of a unit quaternion", "composante d'un quaternion unitaire"},
    {"angular velocity in moving axes", "vitesse de rotation, en axes mobiles"},
    {"of the constraint {}", "de l'équation de liaison {}"},
    // Energies
    {"Kinetic energy [J]", "Énergie cinétique [J]"},
    {"Force function [J]", "Fonction de force [J]"},
    {"The kinetic energy is", "L'énergie cinétique est"},
    {"The force function is", "La fonction de force est"},
    {"Equations below with everything but the inputs on the left are",
     "Des équations ci-dessous, où tout sauf les commandes est à gauche, sont"},
    {"The constraint {} is", "L'équation de liaison {} est"},
    {"{} too long to be written out (up to {:.2g} terms before anything cancels; limits: {} of those, {} to be read): named "
     "definitions are at the end.",
     "{} d'écriture trop longue (jusqu'à {:.2g} termes avant simplification ; limites : {} de ceux-là, {} pour être lus) : des "
     "définitions sont données à la fin."},
    // Lagrange
    {"Lagrange's equations", "Équations de Lagrange"},
    {"P_i = d/dt(dT/dq_i') - dT/dq_i on the left, the generalised forces Q_i{} on the right.",
     "P_i = d/dt(dT/dq_i') - dT/dq_i à gauche, les efforts généralisés Q_i{} à droite."},
    {"$P_i = \\frac{{\\mathrm{{d}}}}{{\\mathrm{{d}}t}}\\frac{{\\partial T}}{{\\partial \\dot{{q}}_i}} - \\frac{{\\partial "
     "T}}{{\\partial q_i}}$ on the left, the generalised forces $Q_i{}$ on the right.",
     "$P_i = \\frac{{\\mathrm{{d}}}}{{\\mathrm{{d}}t}}\\frac{{\\partial T}}{{\\partial \\dot{{q}}_i}} - \\frac{{\\partial "
     "T}}{{\\partial q_i}}$ à gauche, les efforts généralisés $Q_i{}$ à droite."},
    {"Along the angular velocity w of an attitude, P = d/dt(dT/dw) + w x dT/dw, less the derivative of T along the same turn.",
     "Suivant la vitesse de rotation w d'une orientation, P = d/dt(dT/dw) + w x dT/dw, moins la dérivée de T suivant la même "
     "rotation."},
    {"Along the angular velocity $\\omega$ of an attitude, $P = \\frac{\\mathrm{d}}{\\mathrm{d}t}\\frac{\\partial T}{\\partial "
     "\\omega} + \\omega \\wedge \\frac{\\partial T}{\\partial \\omega}$, less the derivative of $T$ along the same turn.",
     "Suivant la vitesse de rotation $\\omega$ d'une orientation, $P = \\frac{\\mathrm{d}}{\\mathrm{d}t}\\frac{\\partial "
     "T}{\\partial \\omega} + \\omega \\wedge \\frac{\\partial T}{\\partial \\omega}$, moins la dérivée de $T$ suivant la même "
     "rotation."},
    // Constraints
    {"Constraints", "Équations de liaison"},
    {"holonomic", "holonome"},
    {"non-holonomic", "non holonome"},
    {"{} ({}) holds whatever the motion: it is no equation, and its multiplier is 0.",
     "{} ({}) est vérifiée quel que soit le mouvement : ce n'est pas une équation, et son multiplicateur est nul."},
    {"{} is integrable", "{} est intégrable"},
    {"{} are integrable together", "{} sont intégrables ensemble"},
    {"Constraints that repeat others are left out, their multipliers are 0: {}.",
     "Les équations de liaison qui en répètent d'autres sont omises, leurs multiplicateurs sont nuls : {}."},
    {"Indeterminate, as they are shared with those in a way that no motion tells: {}.",
     "Indéterminés, car leur partage avec ceux-là ne se lit sur aucun mouvement : {}."},
    {"Indeterminate reactions for the same reason: {}.", "Réactions indéterminées pour la même raison : {}."},
    {"Those kept lose rank at places of the motion where one left out counts; these are no change points, and "
     "accelerations lose digits near them.",
     "Celles qui restent perdent leur rang en des endroits du mouvement où une équation écartée compte ; ce ne sont pas des "
     "points de bifurcation, et les accélérations y perdent des chiffres."},
    {"The initial configuration is singular: {} of {} constraints are independent there.",
     "La configuration initiale est singulière : {} des {} équations de liaison y sont indépendantes."},
    {"Equations without multipliers", "Équations sans multiplicateurs"},
    {"The multipliers from the equation of {}, put into the other:",
     "Le multiplicateur tiré de l'équation de {}, reporté dans l'autre :"},
    {"The multipliers from the equation of {}, put into the others:",
     "Le multiplicateur tiré de l'équation de {}, reporté dans les autres :"},
    {"The multipliers from the equations of {}, put into the other:",
     "Les multiplicateurs tirés des équations de {}, reportés dans l'autre :"},
    {"The multipliers from the equations of {}, put into the others:",
     "Les multiplicateurs tirés des équations de {}, reportés dans les autres :"},
    {"They hold where det C is not zero, C the factors of the multipliers in the equations that gave them:",
     "Elles sont valables là où det C n'est pas nul, C étant la matrice des coefficients des multiplicateurs dans les équations qui les "
     "ont donnés :"},
    // Derivation
    {"bodies", "solides"},
    {"actions", "actions"},
    {"joints", "liaisons"},
    {"Not written one by one: there are {} {}, and a page is for {} at most.",
     "Le détail n'est pas écrit : il y a {} {}, et une page en présente {} au plus."},
    {"up to {:.2g} terms before anything cancels, limit {}", "jusqu'à {:.2g} termes avant simplification, limite {}"},
    {"more than {} terms", "plus de {} termes"},
    {"{} is too long to be written out: {}.", "{} est d'écriture trop longue : {}."},
    {"Twist and momentum screw of each body at its centre of mass",
     "Torseur cinématique et torseur cinétique de chaque solide en son centre d'inertie"},
    {"{}, along the axes of {}:", "{}, suivant les axes de {} :"},
    {"V(G of {})", "V(G de {})"},
    {"{Omega; V(G)} and {m V(G); sigma_G}, sigma_G = J_G Omega.", "{Omega ; V(G)} et {m V(G) ; sigma_G}, sigma_G = J_G Omega."},
    {"$\\left\\{\\vec{\\Omega}\\,;\\ \\vec{V}(G)\\right\\}$ and $\\left\\{m \\vec{V}(G)\\,;\\ \\vec{\\sigma}_G\\right\\}$, "
     "$\\vec{\\sigma}_G = J_G\\,\\vec{\\Omega}$.",
     "$\\left\\{\\vec{\\Omega}\\,;\\ \\vec{V}(G)\\right\\}$ et $\\left\\{m \\vec{V}(G)\\,;\\ \\vec{\\sigma}_G\\right\\}$, "
     "$\\vec{\\sigma}_G = J_G\\,\\vec{\\Omega}$."},
    {"Kinetic energy, body by body", "Énergie cinétique, solide par solide"},
    {"T = 1/2 (m V(G)^2 + sigma_G . Omega), in J.", "T = 1/2 (m V(G)^2 + sigma_G . Omega), en J."},
    {"$T = \\frac{1}{2}\\left(m \\vec{V}(G)^2 + \\vec{\\sigma}_G \\cdot \\vec{\\Omega}\\right)$, in J.",
     "$T = \\frac{1}{2}\\left(m \\vec{V}(G)^2 + \\vec{\\sigma}_G \\cdot \\vec{\\Omega}\\right)$, en J."},
    {"Partial derivatives of the kinetic energy", "Dérivées partielles de l'énergie cinétique"},
    {"Those that are missing are too long to be written out: more than {} terms.",
     "Celles qui manquent sont d'écriture trop longue : plus de {} termes."},
    {"Generalised forces, action by action", "Efforts généralisés, action par action"},
    {"gravity", "pesanteur"},
    {"No action works.", "Aucune action ne travaille."},
    {"{}:", "{} :"},
    {"{}: no coordinate that is free makes it work.", "{} : aucun paramètre libre ne la fait travailler."},
    {"{}: friction, in proportion to the multiplier of its contact.",
     "{} : frottement, proportionnel au multiplicateur de son contact."},
    {"What joints transmit", "Efforts transmis par les liaisons"},
    {"By Newton-Euler for what hangs on the joint: force R [N] and moment M [N m] on the body, at the origin of its frame, along "
     "its axes. Motors and springs in the joint are part of them.",
     "Par le principe fondamental pour ce que porte la liaison : résultante R [N] et moment M [N m] sur le solide, à l'origine de "
     "son repère, suivant ses axes. Moteurs et ressorts de la liaison y sont compris."},
    {"{}, on {}:", "{}, sur {} :"},
    {"What has more than {} terms, or more than {} before anything cancels, is given by the named definitions at the end.",
     "Ce qui a plus de {} termes, ou plus de {} avant simplification, est donné par les définitions de la fin."},
    {"entries that are not zero", "termes non nuls"},
    {"by components", "par composantes"},
    // Meanings of definitions, before "of NAME"
    {"{} of {}", "{} de {}"},
    {"angular velocity", "vitesse de rotation"},
    {"velocity", "vitesse"},
    {"angular acceleration", "accélération angulaire"},
    {"acceleration", "accélération"},
    {"acceleration of joint {}", "accélération de la liaison {}"},
    {"place", "position"},
    {"first moment", "moment statique"},
    {"minus gravity in the axes", "opposé de la pesanteur en axes"},
    {"pivot", "pivot d'élimination"},
    {"normal of the plane times axis of the disc at {}", "normale au plan scalaire axe du disque en {}"},
    // Linearisation
    {"Linearised equations", "Équations linéarisées"},
    {"Not printed, because the equations are too long to be written out: generate the kernel linearisation.",
     "Non écrites, car les équations sont trop longues : engendrer le noyau linearisation."},
    {"Not printed about any state, because the equations have {} terms together (limit {}): name a state by --about, or generate the kernel "
     "linearisation.",
     "Non écrites autour d'un état quelconque, car les équations ont {} termes en tout (limite {}) : nommer un état par --about, ou "
     "engendrer le noyau linearisation."},
    {"M e'' + C e' + K e = F + E u, e the deviation from the state, in the order of the coordinates.",
     "M e'' + C e' + K e = F + E u, e l'écart à l'état, dans l'ordre des paramètres."},
    {"$\\mathbf{M} \\ddot{\\varepsilon} + \\mathbf{C} \\dot{\\varepsilon} + \\mathbf{K} \\varepsilon = \\mathbf{F} + \\mathbf{E} "
     "u$, $\\varepsilon$ the deviation from the state, in the order of the coordinates.",
     "$\\mathbf{M} \\ddot{\\varepsilon} + \\mathbf{C} \\dot{\\varepsilon} + \\mathbf{K} \\varepsilon = \\mathbf{F} + \\mathbf{E} "
     "u$, $\\varepsilon$ l'écart à l'état, dans l'ordre des paramètres."},
    {"Along an attitude e is a turn in its moving axes; e' and e'' stand for w and w', w the deviation of its angular velocity "
     "omega, w = de/dt + omega x e.",
     "Pour une attitude, e est une rotation dans ses axes mobiles ; e' et e'' tiennent lieu de w et w', w l'écart de sa "
     "vitesse de rotation omega, w = de/dt + omega x e."},
    {"Along an attitude $\\varepsilon$ is a turn in its moving axes; $\\dot{\\varepsilon}$ and $\\ddot{\\varepsilon}$ stand for "
     "$w$ and $\\dot{w}$, $w$ the deviation of its angular velocity $\\omega$, "
     "$w = \\frac{\\mathrm{d}\\varepsilon}{\\mathrm{d}t} + \\omega \\wedge \\varepsilon$.",
     "Pour une attitude, $\\varepsilon$ est une rotation dans ses axes mobiles ; $\\dot{\\varepsilon}$ et $\\ddot{\\varepsilon}$ "
     "tiennent lieu de $w$ et $\\dot{w}$, $w$ l'écart de sa vitesse de rotation $\\omega$, $w = "
     "\\frac{\\mathrm{d}\\varepsilon}{\\mathrm{d}t} + \\omega \\wedge \\varepsilon$."},
    {"the rate of {}", "la dérivée de {}"},
    {"{}: must hold at this state", "{} : doit être vérifiée à cet état"},
    {"There is no linearisation: forces or their slopes have two values at this state, one on either side of",
     "Il n'y a pas de linéarisation : des forces ou leurs pentes ont deux valeurs à cet état, une de chaque côté de"},
    {"a condition that is too long to be written out", "une condition d'écriture trop longue"},
    {"Laws with two forms there: {}.", "Lois qui y ont deux formes : {}."},
    {"The matrices are those of one form, or of what stands between them.",
     "Les matrices sont celles d'une des formes, ou de ce qui est entre elles."},
    {"{}: does not hold at this state", "{} : n'est pas vérifiée à cet état"},
    {"What the state leaves of {} must vanish; it is too long to be written out.",
     "Ce que l'état laisse de {} doit s'annuler ; c'est trop long à écrire."},
    {"About any state without acceleration.", "Autour d'un état quelconque sans accélération."},
    {"About {}; velocities and accelerations not named are zero.",
     "Autour de {} ; vitesses et accélérations non nommées sont nulles."},
    {"At fixed multipliers, in all coordinates: A' dlambda and the linearised constraints come beside it.",
     "À multiplicateurs fixés, pour tous les paramètres : A' dlambda et les équations de liaison linéarisées s'y ajoutent."},
    {"At fixed multipliers, in all coordinates: $\\mathbf{A}^{\\mathsf{T}}\\, \\delta\\lambda$ and the linearised constraints come "
     "beside it.",
     "À multiplicateurs fixés, pour tous les paramètres : $\\mathbf{A}^{\\mathsf{T}}\\, \\delta\\lambda$ et les équations de liaison "
     "linéarisées s'y ajoutent."},
    {"The entries have {} terms together (limit {}): name a state by --about, or generate the kernel linearisation.",
     "Les termes de matrice comptent {} termes en tout (limite {}) : nommer un état par --about, ou engendrer le noyau linearisation."},
    {"In no equation: {}.", "Dans aucune équation : {}."},
    {"Linearised equations in independent freedoms", "Équations linéarisées en paramètres indépendants"},
    {"Not reduced: {}.", "Non réduites : {}."},
    {"An entry has more than {} terms: name a state by --about, or generate the kernel linearisation.",
     "Un terme de matrice compte plus de {} termes : nommer un état par --about, ou engendrer le noyau linearisation."},
    {"An entry has more than {} terms: generate the kernel linearisation.",
     "Un terme de matrice compte plus de {} termes : engendrer le noyau linearisation."},
    {"None is left: the constraints determine all velocities.",
     "Il n'en reste aucun : les liaisons déterminent toutes les vitesses."},
    {"M_r e'' + C_r e' + K_r e = F_r + E_r u, e the deviations of the freedoms below; the others follow.",
     "M_r e'' + C_r e' + K_r e = F_r + E_r u, e les écarts des paramètres ci-dessous ; les autres suivent."},
    {"$\\mathbf{M}_r \\ddot{e} + \\mathbf{C}_r \\dot{e} + \\mathbf{K}_r e = \\mathbf{F}_r + \\mathbf{E}_r u$, $e$ the deviations of "
     "the freedoms below; the others follow.",
     "$\\mathbf{M}_r \\ddot{e} + \\mathbf{C}_r \\dot{e} + \\mathbf{K}_r e = \\mathbf{F}_r + \\mathbf{E}_r u$, $e$ les écarts des "
     "paramètres ci-dessous ; les autres suivent."},
    {"Independent: {}. Multipliers are those of the state.", "Indépendants : {}. Les multiplicateurs sont ceux de l'état."},
    {"M_r w' + C_r w + K_r e = F_r + E_r u, e' = D e + N w, e and w the deviations below; the others follow.",
     "M_r w' + C_r w + K_r e = F_r + E_r u, e' = D e + N w, e et w les écarts ci-dessous ; les autres suivent."},
    {"$\\mathbf{M}_r \\dot{w} + \\mathbf{C}_r w + \\mathbf{K}_r e = \\mathbf{F}_r + \\mathbf{E}_r u$, $\\dot{e} = \\mathbf{D} e + "
     "\\mathbf{N} w$, $e$ and $w$ the deviations below; the others follow.",
     "$\\mathbf{M}_r \\dot{w} + \\mathbf{C}_r w + \\mathbf{K}_r e = \\mathbf{F}_r + \\mathbf{E}_r u$, $\\dot{e} = \\mathbf{D} e + "
     "\\mathbf{N} w$, $e$ et $w$ les écarts ci-dessous ; les autres suivent."},
    {"$e$: of {}; $w$: of the rates of {}. Multipliers are those of the state.",
     "$e$ : de {} ; $w$ : des vitesses de {}. Les multiplicateurs sont ceux de l'état."},
    {"e: of {}; w: of the rates of {}. Multipliers are those of the state.",
     "e : de {} ; w : des vitesses de {}. Les multiplicateurs sont ceux de l'état."},
    // Painlevé and first integrals
    {"Painleve's equation and first integrals", "Équation de Painlevé et intégrales premières"},
    {"d(T2 - T0)/dt + dT/dt = sum_i Q_i q_i'{}, dT/dt at constant q and q'.",
     "d(T2 - T0)/dt + dT/dt = sum_i Q_i q_i'{}, dT/dt à q et q' constants."},
    {"{}: {}, too long to be written out ({}); kernels compute it.",
     "{} : {}, d'écriture trop longue ({}) ; les noyaux la calculent."},
    {"nothing is driven", "aucun mouvement n'est imposé"},
    {"in J", "en J"},
    {"{}, in {}", "{}, en {}"},
    {"partial derivative at constant q and q', in W", "dérivée partielle à q et q' constants, en W"},
    {"$T_2 - T_0 - U$ is not conserved: {}.", "$T_2 - T_0 - U$ ne se conserve pas : {}."},
    {"T2 - T0 - U is not conserved: {}.", "T2 - T0 - U ne se conserve pas : {}."},
    {"constant", "constante"},
    {"\\text{constant}", "\\text{constante}"},
    {"No momentum integral along {}: {}.", "Pas d'intégrale première du moment conjugué suivant {} : {}."},
    {"nothing has mass", "rien n'a de masse"},
    {"{} has no force function", "{} ne dérive pas d'une fonction de force"},
    {"{} have no force function", "{} ne dérivent pas d'une fonction de force"},
    {"{} has a force function that is not stated", "{} dérive d'une fonction de force qui n'est pas donnée"},
    {"{} have force functions that are not stated", "{} dérivent de fonctions de force qui ne sont pas données"},
    {"T depends on time explicitly", "T dépend explicitement du temps"},
    {"the force function U depends on time explicitly", "la fonction de force U dépend explicitement du temps"},
    {"the force function U jumps", "la fonction de force U a des sauts"},
    {"constraint '{}' imposes a velocity (b is not zero)", "l'équation de liaison '{}' impose une vitesse (b n'est pas nul)"},
    {"dT/d{}' of the cyclic coordinate '{}'", "dT/d{}' du paramètre cyclique '{}'"},
    {"$\\frac{{\\partial T}}{{\\partial {}}}$ of the cyclic coordinate ${}$",
     "$\\frac{{\\partial T}}{{\\partial {}}}$ du paramètre cyclique ${}$"},
    {"dT/d{}, constant in the moving axes", "dT/d{}, constant en axes mobiles"},
    {"T has no momentum along it", "T n'en contient pas la vitesse"},
    {"T depends on it", "T en dépend"},
    {"forces act along it", "des efforts travaillent suivant elle"},
    {"axis {} of '{}'", "l'axe {} de '{}'"},
    {"axis {} of '{}' through the origin of '{}'", "l'axe {} de '{}' passant par l'origine de '{}'"},
    {"an axis along {} of '{}' through where {} and {} are zero", "un axe suivant {} de '{}' passant par le point où {} et {} sont nuls"},
    {"The momentum about {} is constant, and too long to be written out ({}).",
     "Le moment cinétique autour de {} est constant, et trop long pour être écrit ({})."},
    {"momentum about {}, in N m s", "moment cinétique autour de {}, en N m s"},
    {"No momentum integral about {}: {}.", "Pas d'intégrale première du moment cinétique autour de {} : {}."},
    {"its axes turn with the body", "ses axes tournent avec le solide"},
    {"U depends on it", "U en dépend"},
    {"{} acts along it", "{} travaille suivant ce paramètre"},
    {"{} act along it", "{} travaillent suivant ce paramètre"},
    // Contacts
    {"Contacts that open and close", "Contacts unilatéraux"},
    {"g is the gap and w its rate (N) or a slip (T), of the first body on the second.",
     "g est l'écartement, w sa vitesse (N) ou une vitesse de glissement (T), du premier solide sur le second."},
    {"w is the slip.", "w est la vitesse de glissement."},
    {"They are those of the mechanism on which no contact acts.", "Elles valent pour le mécanisme sans action de contact."},
    {"What follows of first integrals and small motions is that of the mechanism on which no contact acts.",
     "Ce qui suit sur les intégrales premières et les petits mouvements vaut pour le mécanisme sans action de contact."},
    {"Too long to be written out: {}; the kernel contacts computes what they are made of.",
     "D'écriture trop longue : {} ; le noyau contacts calcule ce dont elles sont faites."},
    {"{} is too long to be written out ({}); the kernel contacts computes it.",
     "{} est d'écriture trop longue ({}) ; le noyau contacts le calcule."},
    {"{}, dry friction alone:", "{}, frottement sec seul :"},
    {"{}, w an angular velocity, pressed by {}:", "{}, w une vitesse de rotation, pressé par {} :"},
    {"{}, friction of a joint, pressed by what it transmits across its axis:",
     "{}, frottement d'une liaison, pressé par ce qu'elle transmet perpendiculairement à son axe :"},
    {"Friction of joints: |T| <= f_s |R| while w_T = 0, T = -f |R| w_T/|w_T| while they slide, h_s and h in the place of f_s and "
     "f where they turn, R what the joint transmits across its axis.",
     "Frottement des liaisons : |T| <= f_s |R| tant que w_T = 0, T = -f |R| w_T/|w_T| pendant le glissement, h_s et h au lieu de f_s "
     "et f en rotation, R ce que la liaison transmet perpendiculairement à son axe."},
    {"Friction of joints: $|T| \\le f_s |R|$ while $w_T = 0$, $T = -f |R| \\frac{w_T}{|w_T|}$ while they slide, $h_s$ and $h$ in "
     "the place of $f_s$ and $f$ where they turn, $R$ what the joint transmits across its axis.",
     "Frottement des liaisons : $|T| \\le f_s |R|$ tant que $w_T = 0$, $T = -f |R| \\frac{w_T}{|w_T|}$ pendant le glissement, $h_s$ "
     "et $h$ au lieu de $f_s$ et $f$ en rotation, $R$ ce que la liaison transmet perpendiculairement à son axe."},
    {"Joints rub by |P_T| <= f |P_R|, P_R the impulse that they transmit.",
     "Les liaisons frottent par |P_T| <= f |P_R|, P_R la percussion qu'elles transmettent."},
    {"a length", "une longueur"},
    {"Resistance to rolling and spinning: |T| <= h N while w_T = 0, T = -h N w_T/|w_T| while it turns, T a moment, N that of the "
     "contact that presses.",
     "Résistance au roulement et au pivotement : |T| <= h N tant que w_T = 0, T = -h N w_T/|w_T| pendant la rotation, T un moment, N "
     "celui du contact qui presse."},
    {"Resistance to rolling and spinning: $|T| \\le h N$ while $w_T = 0$, $T = -h N \\frac{w_T}{|w_T|}$ while it turns, $T$ a "
     "moment, $N$ that of the contact that presses.",
     "Résistance au roulement et au pivotement : $|T| \\le h N$ tant que $w_T = 0$, $T = -h N \\frac{w_T}{|w_T|}$ pendant la "
     "rotation, $T$ un moment, $N$ celui du contact qui presse."},
    {"while it slides", "pendant le glissement"},
    {"while it sticks", "pendant l'adhérence"},
    {"restitution", "restitution"},
    {"Their reactions add Q_i = sum r dw/dq_i' to the right of Lagrange's equations, r = N or T of each w:",
     "Leurs réactions ajoutent Q_i = sum r dw/dq_i' à droite des équations de Lagrange, r = N ou T de chaque w :"},
    {"Their reactions add $Q_i = \\sum r\\, \\frac{\\partial w}{\\partial \\dot{q}_i}$ to the right of Lagrange's equations, $r = "
     "N$ or $T$ of each $w$:",
     "Leurs réactions ajoutent $Q_i = \\sum r\\, \\frac{\\partial w}{\\partial \\dot{q}_i}$ à droite des équations de Lagrange, $r "
     "= N$ ou $T$ de chaque $w$ :"},
    {"Laws of contact", "Lois de contact"},
    {"Signorini: 0 <= g, 0 <= N, N g = 0; while g = 0 and w_N = 0: 0 <= dw_N/dt, 0 <= N, N dw_N/dt = 0.",
     "Signorini : 0 <= g, 0 <= N, N g = 0 ; tant que g = 0 et w_N = 0 : 0 <= dw_N/dt, 0 <= N, N dw_N/dt = 0."},
    {"Signorini: $0 \\le g$, $0 \\le N$, $N g = 0$; while $g = 0$ and $w_N = 0$: $0 \\le \\dot{w}_N$, $0 \\le N$, $N \\dot{w}_N = "
     "0$.",
     "Signorini : $0 \\le g$, $0 \\le N$, $N g = 0$ ; tant que $g = 0$ et $w_N = 0$ : $0 \\le \\dot{w}_N$, $0 \\le N$, $N "
     "\\dot{w}_N = 0$."},
    {"Open: g > 0, N = 0, T = 0.", "Ouvert : g > 0, N = 0, T = 0."},
    {"Open: $g > 0$, $N = 0$, $T = 0$.", "Ouvert : $g > 0$, $N = 0$, $T = 0$."},
    {"Sticks: w_T = 0, |T| <= f_s N{}.", "Adhérence : w_T = 0, |T| <= f_s N{}."},
    {"Sticks: $w_T = 0$, $|T| \\le f_s N${}.", "Adhérence : $w_T = 0$, $|T| \\le f_s N${}."},
    {" (b_s of dry friction alone)", " (b_s pour le frottement sec seul)"},
    {" ($b_s$ of dry friction alone)", " ($b_s$ pour le frottement sec seul)"},
    {"Slides: T = -f N w_T/|w_T|{}; where a slip begins, along dw_T/dt in the place of w_T.",
     "Glissement : T = -f N w_T/|w_T|{} ; au début du glissement, suivant dw_T/dt au lieu de w_T."},
    {"Slides: $T = -f N \\frac{{w_T}}{{|w_T|}}${}; where a slip begins, along $\\dot{{w}}_T$ in the place of $w_T$.",
     "Glissement : $T = -f N \\frac{{w_T}}{{|w_T|}}${} ; au début du glissement, suivant $\\dot{{w}}_T$ au lieu de $w_T$."},
    {", b in the place of f N for dry friction alone", ", b au lieu de f N pour le frottement sec seul"},
    {", $b$ in the place of $f N$ for dry friction alone", ", $b$ au lieu de $f N$ pour le frottement sec seul"},
    {"Percussions", "Percussions"},
    {"[[X]] = X+ - X- at an impact: [[dT/dq_i']] = sum P dw/dq_i'{}, P = P_N or P_T of each w.",
     "[[X]] = X+ - X- lors d'un choc : [[dT/dq_i']] = sum P dw/dq_i'{}, P = P_N ou P_T de chaque w."},
    {"$[\\![X]\\!] = X^+ - X^-$ at an impact: $\\left[\\!\\left[\\frac{{\\partial T}}{{\\partial "
     "\\dot{{q}}_i}}\\right]\\!\\right] = \\sum P\\, \\frac{{\\partial w}}{{\\partial \\dot{{q}}_i}}{}$, $P = P_N$ or $P_T$ of each "
     "$w$.",
     "$[\\![X]\\!] = X^+ - X^-$ lors d'un choc : $\\left[\\!\\left[\\frac{{\\partial T}}{{\\partial "
     "\\dot{{q}}_i}}\\right]\\!\\right] = \\sum P\\, \\frac{{\\partial w}}{{\\partial \\dot{{q}}_i}}{}$, $P = P_N$ ou $P_T$ de "
     "chaque $w$."},
    {"Impulses stand where reactions stand above; bounded forces have none.",
     "Les percussions remplacent les réactions ci-dessus ; les efforts bornés n'en donnent pas."},
    {"Newton-Moreau: 0 <= w_N+ + e w_N-, 0 <= P_N, P_N (w_N+ + e w_N-) = 0.",
     "Newton-Moreau : 0 <= w_N+ + e w_N-, 0 <= P_N, P_N (w_N+ + e w_N-) = 0."},
    {"Newton-Moreau: $0 \\le w_N^+ + e\\, w_N^-$, $0 \\le P_N$, $P_N (w_N^+ + e\\, w_N^-) = 0$.",
     "Newton-Moreau : $0 \\le w_N^+ + e\\, w_N^-$, $0 \\le P_N$, $P_N (w_N^+ + e\\, w_N^-) = 0$."},
    {"Friction: |P_T| <= f P_N where w_T+ = 0, P_T = -f P_N w_T+/|w_T+| elsewhere.",
     "Frottement : |P_T| <= f P_N si w_T+ = 0, sinon P_T = -f P_N w_T+/|w_T+|."},
    {"Friction: $|P_T| \\le f P_N$ where $w_T^+ = 0$, $P_T = -f P_N \\frac{w_T^+}{|w_T^+|}$ elsewhere.",
     "Frottement : $|P_T| \\le f P_N$ si $w_T^+ = 0$, sinon $P_T = -f P_N \\frac{w_T^+}{|w_T^+|}$."},
    {"Carnot's loss: T- - T+ = -1/2 sum P (w+ + w-) + sum P b{}, b what w is where all velocities are 0: surfaces that move by "
     "themselves give energy, too.",
     "Perte de Carnot : T- - T+ = -1/2 sum P (w+ + w-) + sum P b{}, b étant w à vitesses nulles : les surfaces mues par ailleurs "
     "fournissent aussi de l'énergie."},
    {"Carnot's loss: $T^- - T^+ = -\\frac{{1}}{{2}} \\sum P\\,(w^+ + w^-) + \\sum P\\, b{}$, $b$ what $w$ is where all "
     "velocities are 0: surfaces that move by themselves give energy, too.",
     "Perte de Carnot : $T^- - T^+ = -\\frac{{1}}{{2}} \\sum P\\,(w^+ + w^-) + \\sum P\\, b{}$, $b$ étant $w$ à vitesses nulles : "
     "les surfaces mues par ailleurs fournissent aussi de l'énergie."},
    {"Carnot's loss: T- - T+ = -1/2 sum P (w+ + w-); of one contact without friction -1/2 (1 - e) P_N w_N- >= 0.",
     "Perte de Carnot : T- - T+ = -1/2 sum P (w+ + w-) ; d'un contact sans frottement -1/2 (1 - e) P_N w_N- >= 0."},
    {"Carnot's loss: $T^- - T^+ = -\\frac{1}{2} \\sum P\\,(w^+ + w^-)$; of one contact without friction $-\\frac{1}{2} (1 - e) P_N "
     "w_N^- \\ge 0$.",
     "Perte de Carnot : $T^- - T^+ = -\\frac{1}{2} \\sum P\\,(w^+ + w^-)$ ; d'un contact sans frottement $-\\frac{1}{2} (1 - e) P_N "
     "w_N^- \\ge 0$."},
};

}  // namespace torsor
