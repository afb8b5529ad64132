/**
 * {@code serve}: runs and a campaign in browsers. {@link org.starl.cli.serve.Site} is what is shown;
 * a {@link org.starl.cli.serve.PageServer}, which another module has, serves it.
 *
 * <p>May import: {@code org.starl.cli.command}, {@code org.starl.cli.request}, {@code
 * org.starl.cli.run}, {@code org.starl.cli.campaign}, {@code org.starl.cli.schema}, {@code
 * org.starl.cli.report}; all other modules.
 */
@NullMarked
package org.starl.cli.serve;

import org.jspecify.annotations.NullMarked;
