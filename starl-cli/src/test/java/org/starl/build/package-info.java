/**
 * Holds the whole repository to its own rules: the two builds agree, modules and packages import
 * what they may, sources are tidy. Each rule is also shown to be able to fail.
 *
 * <p>May import: the JDK, ArchUnit; it reads every other module as files and classes.
 */
@NullMarked
package org.starl.build;

import org.jspecify.annotations.NullMarked;
