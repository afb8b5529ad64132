/**
 * Monitors of an app's own: {@link org.starl.primitives.monitor.AppMonitor} passes what the
 * primitives did to typed methods. {@link org.starl.primitives.monitor.PrimitiveVocabulary} has the
 * shapes of all primitives, for readers of traces.
 *
 * <p>Contract: a monitor reads a run's events and changes nothing. Its methods are called in the
 * order of the events.
 *
 * <p>May import: core and the primitives.
 */
@NullMarked
package org.starl.primitives.monitor;

import org.jspecify.annotations.NullMarked;
