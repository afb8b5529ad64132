/** Tests of what is checked of a search. */
@NullMarked
package org.starl.apps.search.spec;

import org.jspecify.annotations.NullMarked;
