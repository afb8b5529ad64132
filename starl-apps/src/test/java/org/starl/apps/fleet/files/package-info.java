/** Tests of the readers of navigation graphs and deliveries. May import: core, input. */
@NullMarked
package org.starl.apps.fleet.files;

import org.jspecify.annotations.NullMarked;
