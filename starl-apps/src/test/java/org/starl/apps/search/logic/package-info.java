/** Tests of the search's logic, and a searcher that is rude. */
@NullMarked
package org.starl.apps.search.logic;

import org.jspecify.annotations.NullMarked;
