/** Tests of the Create's driver against the simulated Create, byte by byte. */
@NullMarked
package org.starl.robot.create;

import org.jspecify.annotations.NullMarked;
