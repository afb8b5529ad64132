/**
 * What a deployment file says: which robots there are, where they are reached, on which wheels they
 * stand, who measures where they are, which app they run and under which key. {@link
 * org.starl.deploy.file.DeploymentReader} makes a {@link org.starl.deploy.file.Deployment} of a tree of
 * {@link org.starl.deploy.file.Node}s; who has the file (YAML on a Linux board, JSON on a phone) makes
 * the tree. What is wrong is told in one line: file, line, value, what was expected.
 *
 * <p>Nothing is opened and nobody is asked here: names, numbers and what contradicts itself, no more.
 *
 * <p>May import: the JDK as far as Android API 26 has it, {@code org.starl} ids.
 */
@NullMarked
package org.starl.deploy.file;

import org.jspecify.annotations.NullMarked;
