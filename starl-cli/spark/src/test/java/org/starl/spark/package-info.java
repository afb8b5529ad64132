@NullMarked
package org.starl.spark;

import org.jspecify.annotations.NullMarked;
