/**
 * Robots that deliver along the lanes of a navigation graph. It runs on robots: no simulator, no screen,
 * no file.
 */
@NullMarked
package org.starl.apps.fleet.logic;

import org.jspecify.annotations.NullMarked;
