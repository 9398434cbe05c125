"""What claims are tried on: arrangements, grasps, and the rows printed in the paper."""
