/** Tests of the distributed search. */
@NullMarked
package org.starl.apps.search;

import org.jspecify.annotations.NullMarked;
