/**
 * The API of an app (paper, section 2): {@link org.starl.LogicThread}, the app's blocking state
 * machine, and {@link org.starl.GlobalVarHolder}, the {@code gvh} that gives access to everything
 * else. All code of a robot runs on that robot's strand; do not call it from other threads.
 *
 * <p>This module is the interface and the logic layer of Figure 1 and the ports below them.
 *
 * <p>May import: the JDK, as far as a phone with API level 26 has it, JSpecify, core.
 */
@NullMarked
package org.starl;

import org.jspecify.annotations.NullMarked;
