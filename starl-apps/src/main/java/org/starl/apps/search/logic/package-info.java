/**
 * Distributed search (paper, section 5.4): robots elect a leader, the leader assigns rooms, each
 * robot searches its rooms, and all end with one answer.
 *
 * <p>{@link org.starl.apps.search.logic.SearchApp} is the robot. Its {@link
 * org.starl.apps.search.logic.House} is its map: rooms, and where it may stand; {@link
 * org.starl.platform.ObjectSensor} is its sensor. Election, SetAgreement, Broadcast, Suspicion
 * and DistributedPathPlanning do the work.
 *
 * <p>Distances in mm. Strand only, unless a class says that it is immutable.
 *
 * <p>May import: core and primitives only.
 */
@NullMarked
package org.starl.apps.search.logic;

import org.jspecify.annotations.NullMarked;
