/** Tests of what is checked of a race. */
@NullMarked
package org.starl.apps.race.spec;

import org.jspecify.annotations.NullMarked;
