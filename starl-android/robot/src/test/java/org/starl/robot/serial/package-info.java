/** Tests of pseudo terminals with the machine's own. */
@NullMarked
package org.starl.robot.serial;

import org.jspecify.annotations.NullMarked;
