/** Holds the pages of {@code docs/} to the code that they speak of. May import: the JDK. */
@NullMarked
package org.starl.docs;

import org.jspecify.annotations.NullMarked;
