@NullMarked
package org.starl.workload;

import org.jspecify.annotations.NullMarked;
