/**
 * The intersection's specifications (paper, sections 3 and 3.5): {@code traffic_safety}, {@code
 * traffic_progress}, {@code Inv_mux_safety}, {@code Inv_list_crit}, as monitors; and the replay of runs
 * on the theory {@code Traffic_decls}.
 *
 * <p>May import: core, primitives, {@code logic} beside it.
 */
@NullMarked
package org.starl.apps.intersection.spec;

import org.jspecify.annotations.NullMarked;
