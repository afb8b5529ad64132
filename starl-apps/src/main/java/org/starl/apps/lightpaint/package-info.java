/**
 * Light painting (paper, section 5.4): several robots paint a drawing with their lights, as a
 * simulation; readers of drawings.
 *
 * <p>May import: core, primitives, sim, {@code org.starl.apps}, {@code logic}, {@code spec} and
 * {@code view} beside it.
 */
@NullMarked
package org.starl.apps.lightpaint;

import org.jspecify.annotations.NullMarked;
