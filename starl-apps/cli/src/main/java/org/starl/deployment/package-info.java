/**
 * Deployments on a Linux board: reads their files, runs their robots in real time, each as a process of
 * its own, and merges the traces that these leave. What a phone needs as well is below, in {@code
 * org.starl.robot}.
 *
 * <p>May import: all modules; not {@code org.starl.apps} nor {@code org.starl.cli}.
 */
@NullMarked
package org.starl.deployment;

import org.jspecify.annotations.NullMarked;
