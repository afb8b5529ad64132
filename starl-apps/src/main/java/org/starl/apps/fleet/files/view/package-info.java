/**
 * Reads images of maps.
 *
 * <p>May import: input, {@code java.awt}, {@code javax.imageio}.
 */
@NullMarked
package org.starl.apps.fleet.files.view;

import org.jspecify.annotations.NullMarked;
