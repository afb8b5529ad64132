/** Tests of the search's logic, and a searcher with planted bugs. */
@NullMarked
package org.starl.apps.search.logic;

import org.jspecify.annotations.NullMarked;
