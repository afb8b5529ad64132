/** A browser, for the tests of pages. */
@NullMarked
package org.starl.browser;

import org.jspecify.annotations.NullMarked;
