/** Tests of the page about a campaign. */
@NullMarked
package org.starl.cli.report;

import org.jspecify.annotations.NullMarked;
