/**
 * Reads navigation graphs and deliveries from files: buildings of Open-RMF's traffic editor, maps of
 * ROS's map_server and Nav2, and lists of deliveries.
 *
 * <p>Contract: lengths are real, in mm; x points east and y north, as in ROS. Equal files give equal graphs. A
 * file that cannot be read raises {@link org.starl.input.BadInput}: one line with the file, the line of
 * the part, its value, and the expected form.
 *
 * <p>May import: core, input, {@code logic} beside it, and {@code view}, which reads images.
 */
@NullMarked
package org.starl.apps.fleet.files;

import org.jspecify.annotations.NullMarked;
