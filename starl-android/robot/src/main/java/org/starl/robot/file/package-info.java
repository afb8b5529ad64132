/**
 * The content of a deployment file: the robots, their addresses and drives, the system that measures
 * their positions, the app that they run and the key. {@link org.starl.robot.file.DeploymentReader}
 * makes a {@link org.starl.robot.file.Deployment} of a text, on a computer and on a phone, by the
 * description in {@link org.starl.robot.file.DeploymentFormat}, from which the JSON schema is made too. An
 * error is one line: file, line, key, value, what was expected.
 *
 * <p>No file but the document is opened and no host looked up here: only names, numbers and
 * contradictions are checked.
 *
 * <p>May import: the JDK as far as Android API 26 has it, {@code org.starl.input}, {@code org.starl}
 * ids.
 */
@NullMarked
package org.starl.robot.file;

import org.jspecify.annotations.NullMarked;
