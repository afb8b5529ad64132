/**
 * Robots that deliver along the lanes of a navigation graph, without a dispatcher.
 *
 * <p>Safety, under all faults of the network and all crashes and restarts ({@code
 * org.starl.apps.fleet.spec} checks it): no two bodies touch, and each delivery is put down at most once.
 * It rests on the exclusion of sections, and on robots that are within 50 mm of their lane and know
 * that. Progress, while the world behaves: each delivery is put down.
 *
 * <p>Envelope: faults of the network, crashes with restarts, bounded errors of clocks and fixes.
 *
 * <p>May import: core and primitives only.
 */
@NullMarked
package org.starl.apps.fleet.logic;

import org.jspecify.annotations.NullMarked;
