/** Tests of deployments. */
@NullMarked
package org.starl.deployment;

import org.jspecify.annotations.NullMarked;
