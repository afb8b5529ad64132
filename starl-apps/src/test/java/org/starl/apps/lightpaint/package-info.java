/** Tests of light painting. May import: core, primitives, sim. */
@NullMarked
package org.starl.apps.lightpaint;

import org.jspecify.annotations.NullMarked;
