/** Tests of pseudo terminals with the machine's own. */
@NullMarked
package org.starl.deploy.serial;

import org.jspecify.annotations.NullMarked;
