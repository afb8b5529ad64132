/**
 * What a deployment file says: which robots there are, where they are reached, on which wheels they
 * stand, who measures where they are, which app they run and under which key. {@link
 * org.starl.robot.file.DeploymentReader} makes a {@link org.starl.robot.file.Deployment} of a tree of
 * {@link org.starl.robot.file.Node}s, which {@link org.starl.robot.file.YamlTree} makes of a text, on
 * a Linux board and on a phone. What is wrong is told in one line: file, line, value, what was expected.
 *
 * <p>Nothing is opened and nobody is asked here: names, numbers and what contradicts itself, no more.
 *
 * <p>May import: the JDK as far as Android API 26 has it, SnakeYAML's events, {@code org.starl} ids.
 */
@NullMarked
package org.starl.robot.file;

import org.jspecify.annotations.NullMarked;
